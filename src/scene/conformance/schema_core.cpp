// SPDX-License-Identifier: MIT
// The objects of glTF 2.0 itself, chapter 5 of its specification.
#include <array>

#include "scene/conformance/schema.h"

namespace lueur::conformance {
namespace {

using Names = std::array<std::string_view, 2>;

// --- accessors and buffers
// ------------------------------------------------------------------------

constexpr std::array kComponentTypes{5120, 5121, 5122, 5123, 5125, 5126};
constexpr std::array kIndexTypes{5121, 5123, 5125};
constexpr std::array<std::string_view, 7> kElementTypes{"SCALAR", "VEC2", "VEC3", "VEC4",
                                                        "MAT2",   "MAT3", "MAT4"};
constexpr std::array kTargets{34962, 34963};

constexpr std::array kSparseIndices{index("bufferView", "bufferViews").must(),
                                    integer("byteOffset").at_least(0),
                                    one_of("componentType", kIndexTypes).must()};
constexpr ObjectRule kSparseIndicesRule{"sparseIndices", kSparseIndices};
constexpr std::array kSparseValues{index("bufferView", "bufferViews").must(),
                                   integer("byteOffset").at_least(0)};
constexpr ObjectRule kSparseValuesRule{"sparseValues", kSparseValues};
constexpr std::array kSparse{integer("count").at_least(1).must(),
                             object("indices", kSparseIndicesRule).must(),
                             object("values", kSparseValuesRule).must()};
constexpr ObjectRule kSparseRule{"sparse", kSparse};

constexpr std::array kAccessor{index("bufferView", "bufferViews"),
                               integer("byteOffset").at_least(0).along_with("bufferView"),
                               one_of("componentType", kComponentTypes).must(),
                               boolean("normalized"),
                               integer("count").at_least(1).must(),
                               one_of("type", kElementTypes).must(),
                               number("max").list_of(),
                               number("min").list_of(),
                               object("sparse", kSparseRule),
                               string("name")};
constexpr ObjectRule kAccessorRule{"accessor", kAccessor};

constexpr std::array kBuffer{string("uri"), integer("byteLength").at_least(1).must(),
                             string("name")};
constexpr ObjectRule kBufferRule{"buffer", kBuffer};

constexpr std::array kBufferView{index("buffer", "buffers").must(),
                                 integer("byteOffset").at_least(0),
                                 integer("byteLength").at_least(1).must(),
                                 integer("byteStride").at_least(4).at_most(252).step(4),
                                 one_of("target", kTargets),
                                 string("name")};
constexpr ObjectRule kBufferViewRule{"bufferView", kBufferView};

// --- animations
// -----------------------------------------------------------------------------------

constexpr std::array<std::string_view, 3> kInterpolations{"LINEAR", "STEP", "CUBICSPLINE"};

constexpr std::array kTarget{index("node", "nodes"), string("path").must()};
constexpr ObjectRule kTargetRule{"animationTarget", kTarget};
constexpr std::array kChannel{integer("sampler").at_least(0).must(),
                              object("target", kTargetRule).must()};
constexpr ObjectRule kChannelRule{"animationChannel", kChannel};
constexpr std::array kAnimationSampler{index("input", "accessors").must(),
                                       index("output", "accessors").must(),
                                       one_of("interpolation", kInterpolations)};
constexpr ObjectRule kAnimationSamplerRule{"animationSampler", kAnimationSampler};
constexpr std::array kAnimation{object("channels", kChannelRule).list_of().must(),
                                object("samplers", kAnimationSamplerRule).list_of().must(),
                                string("name")};
constexpr ObjectRule kAnimationRule{"animation", kAnimation};

// --- cameras
// --------------------------------------------------------------------------------------

constexpr Names kCameraTypes{"perspective", "orthographic"};

constexpr std::array kPerspective{number("aspectRatio").above(0), number("yfov").above(0).must(),
                                  number("zfar").above(0), number("znear").above(0).must()};
constexpr ObjectRule kPerspectiveRule{"perspective", kPerspective};
constexpr std::array kOrthographic{number("xmag").must(), number("ymag").must(),
                                   number("zfar").above(0).must(),
                                   number("znear").at_least(0).must()};
constexpr ObjectRule kOrthographicRule{"orthographic", kOrthographic};
constexpr std::array kCamera{object("perspective", kPerspectiveRule),
                             object("orthographic", kOrthographicRule),
                             one_of("type", kCameraTypes).must(), string("name")};
constexpr ObjectRule kCameraRule{"camera", kCamera, kCameraTypes};

// --- materials and textures
// -----------------------------------------------------------------------

constexpr std::array<std::string_view, 3> kAlphaModes{"OPAQUE", "MASK", "BLEND"};
constexpr std::array kMagnifyingFilters{9728, 9729};
constexpr std::array kMinifyingFilters{9728, 9729, 9984, 9985, 9986, 9987};
constexpr std::array kWraps{33071, 33648, 10497};
constexpr std::array<std::string_view, 2> kImageSources{"uri", "bufferView"};

constexpr std::array kTextureInfo{index("index", "textures").must(),
                                  integer("texCoord").at_least(0), number("scale"),
                                  share("strength")};
constexpr std::array kMetallicRoughness{share("baseColorFactor").list_of(4),
                                        object("baseColorTexture", kTextureInfoRule),
                                        share("metallicFactor"), share("roughnessFactor"),
                                        object("metallicRoughnessTexture", kTextureInfoRule)};
constexpr ObjectRule kMetallicRoughnessRule{"pbrMetallicRoughness", kMetallicRoughness};
constexpr std::array kMaterial{object("pbrMetallicRoughness", kMetallicRoughnessRule),
                               object("normalTexture", kTextureInfoRule),
                               object("occlusionTexture", kTextureInfoRule),
                               object("emissiveTexture", kTextureInfoRule),
                               share("emissiveFactor").list_of(3),
                               one_of("alphaMode", kAlphaModes),
                               number("alphaCutoff").at_least(0),
                               boolean("doubleSided"),
                               string("name")};
constexpr ObjectRule kMaterialRule{"material", kMaterial};

constexpr std::array kImage{string("uri"), string("mimeType"),
                            index("bufferView", "bufferViews").along_with("mimeType"),
                            string("name")};
constexpr ObjectRule kImageRule{"image", kImage, kImageSources};
constexpr std::array kSampler{one_of("magFilter", kMagnifyingFilters),
                              one_of("minFilter", kMinifyingFilters), one_of("wrapS", kWraps),
                              one_of("wrapT", kWraps), string("name")};
constexpr ObjectRule kSamplerRule{"sampler", kSampler};
constexpr std::array kTexture{index("sampler", "samplers"), index("source", "images"),
                              string("name")};
constexpr ObjectRule kTextureRule{"texture", kTexture};

// --- meshes, nodes, scenes, skins
// -----------------------------------------------------------------

constexpr std::array kModes{0, 1, 2, 3, 4, 5, 6};

// Attributes have names of their own; check_meshes() reads them.
constexpr ObjectRule kAttributesRule{"attributes", {}};
constexpr std::array kPrimitive{object("attributes", kAttributesRule).must(),
                                index("indices", "accessors"), index("material", "materials"),
                                one_of("mode", kModes),
                                object("targets", kAttributesRule).list_of()};
constexpr ObjectRule kPrimitiveRule{"primitive", kPrimitive};
constexpr std::array kMesh{object("primitives", kPrimitiveRule).list_of().must(),
                           number("weights").list_of(), string("name")};
constexpr ObjectRule kMeshRule{"mesh", kMesh};

constexpr std::array kNode{index("camera", "cameras"),
                           index("children", "nodes").list_of().once(),
                           index("skin", "skins").along_with("mesh"),
                           number("matrix").list_of(16),
                           index("mesh", "meshes"),
                           number("rotation").list_of(4).at_least(-1).at_most(1),
                           number("scale").list_of(3),
                           number("translation").list_of(3),
                           number("weights").list_of().along_with("mesh"),
                           string("name")};
constexpr ObjectRule kNodeRule{"node", kNode};
constexpr std::array kScene{index("nodes", "nodes").list_of().once(), string("name")};
constexpr ObjectRule kSceneRule{"scene", kScene};
constexpr std::array kSkin{index("inverseBindMatrices", "accessors"), index("skeleton", "nodes"),
                           index("joints", "nodes").list_of().once().must(), string("name")};
constexpr ObjectRule kSkinRule{"skin", kSkin};

constexpr std::array kAsset{string("copyright"), string("generator"), string("version").must(),
                            string("minVersion")};
constexpr ObjectRule kAssetRule{"asset", kAsset};

constexpr std::array kRoot{
    string("extensionsUsed").list_of().once(),
    string("extensionsRequired").list_of().once().along_with("extensionsUsed"),
    object("accessors", kAccessorRule).list_of(),
    object("animations", kAnimationRule).list_of(),
    object("asset", kAssetRule).must(),
    object("buffers", kBufferRule).list_of(),
    object("bufferViews", kBufferViewRule).list_of(),
    object("cameras", kCameraRule).list_of(),
    object("images", kImageRule).list_of(),
    object("materials", kMaterialRule).list_of(),
    object("meshes", kMeshRule).list_of(),
    object("nodes", kNodeRule).list_of(),
    object("samplers", kSamplerRule).list_of(),
    index("scene", "scenes"),
    object("scenes", kSceneRule).list_of(),
    object("skins", kSkinRule).list_of(),
    object("textures", kTextureRule).list_of()};

}  // namespace

const ObjectRule kTextureInfoRule{"textureInfo", kTextureInfo};
const ObjectRule kRootRule{"glTF", kRoot};

}  // namespace lueur::conformance
