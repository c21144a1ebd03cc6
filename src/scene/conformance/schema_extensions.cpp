// SPDX-License-Identifier: MIT
// The objects of extensions, and where each may stand. Extensions that are not listed here are not
// judged.
#include <array>

#include "scene/conformance/schema.h"

namespace lueur::conformance {
namespace {

constexpr std::array kImageSource{index("source", "images")};
constexpr ObjectRule kImageSourceRule{"textureSource", kImageSource};

constexpr std::array kPointer{string("pointer").must()};
constexpr ObjectRule kPointerRule{"animationPointer", kPointer};

// --- lights
// ---------------------------------------------------------------------------------------

constexpr std::array<std::string_view, 3> kLightTypes{"directional", "point", "spot"};
constexpr double kRightAngle = 1.5707963267948966;

constexpr std::array kSpot{number("innerConeAngle").at_least(0).at_most(kRightAngle),
                           number("outerConeAngle").above(0).at_most(kRightAngle)};
constexpr ObjectRule kSpotRule{"spot", kSpot};
constexpr std::array kLight{share("color").list_of(3),          number("intensity").at_least(0),
                            number("range").above(0),           object("spot", kSpotRule),
                            one_of("type", kLightTypes).must(), string("name")};
constexpr ObjectRule kLightRule{"light", kLight};
constexpr std::array kLights{object("lights", kLightRule).list_of().must()};
constexpr ObjectRule kLightsRule{"lights", kLights};
constexpr std::array kLightOfNode{index("light", "/extensions/KHR_lights_punctual/lights").must()};
constexpr ObjectRule kLightOfNodeRule{"lightOfNode", kLightOfNode};

// --- materials
// ------------------------------------------------------------------------------------

constexpr std::array kAnisotropy{share("anisotropyStrength"), number("anisotropyRotation"),
                                 object("anisotropyTexture", kTextureInfoRule)};
constexpr ObjectRule kAnisotropyRule{"anisotropy", kAnisotropy};
constexpr std::array kClearcoat{
    share("clearcoatFactor"), object("clearcoatTexture", kTextureInfoRule),
    share("clearcoatRoughnessFactor"), object("clearcoatRoughnessTexture", kTextureInfoRule),
    object("clearcoatNormalTexture", kTextureInfoRule)};
constexpr ObjectRule kClearcoatRule{"clearcoat", kClearcoat};
constexpr std::array kDispersion{number("dispersion").at_least(0)};
constexpr ObjectRule kDispersionRule{"dispersion", kDispersion};
constexpr std::array kEmissiveStrength{number("emissiveStrength").at_least(0)};
constexpr ObjectRule kEmissiveStrengthRule{"emissiveStrength", kEmissiveStrength};
constexpr std::array kIridescence{share("iridescenceFactor"),
                                  object("iridescenceTexture", kTextureInfoRule),
                                  number("iridescenceIor").at_least(1),
                                  number("iridescenceThicknessMinimum").at_least(0),
                                  number("iridescenceThicknessMaximum").at_least(0),
                                  object("iridescenceThicknessTexture", kTextureInfoRule)};
constexpr ObjectRule kIridescenceRule{"iridescence", kIridescence};
constexpr std::array kSheen{
    share("sheenColorFactor").list_of(3), object("sheenColorTexture", kTextureInfoRule),
    share("sheenRoughnessFactor"), object("sheenRoughnessTexture", kTextureInfoRule)};
constexpr ObjectRule kSheenRule{"sheen", kSheen};
constexpr std::array kSpecular{share("specularFactor"), object("specularTexture", kTextureInfoRule),
                               number("specularColorFactor").list_of(3).at_least(0),
                               object("specularColorTexture", kTextureInfoRule)};
constexpr ObjectRule kSpecularRule{"specular", kSpecular};
constexpr std::array kSpecularGlossiness{
    share("diffuseFactor").list_of(4), object("diffuseTexture", kTextureInfoRule),
    share("specularFactor").list_of(3), share("glossinessFactor"),
    object("specularGlossinessTexture", kTextureInfoRule)};
constexpr ObjectRule kSpecularGlossinessRule{"pbrSpecularGlossiness", kSpecularGlossiness};
constexpr std::array kTransmission{share("transmissionFactor"),
                                   object("transmissionTexture", kTextureInfoRule)};
constexpr ObjectRule kTransmissionRule{"transmission", kTransmission};
constexpr std::array kVolume{
    number("thicknessFactor").at_least(0), object("thicknessTexture", kTextureInfoRule),
    number("attenuationDistance").above(0), share("attenuationColor").list_of(3)};
constexpr ObjectRule kVolumeRule{"volume", kVolume};
constexpr std::array kIor{number("ior").at_least(0)};  // 0 or 1 and more: check_materials()
constexpr ObjectRule kIorRule{"ior", kIor};

// --- geometry
// --------------------------------------------------------------------------------------

// Attributes may have names of their own, too.
constexpr ObjectRule kInstanceAttributesRule{"instanceAttributes", {}};
constexpr std::array kInstancing{object("attributes", kInstanceAttributesRule).must()};
constexpr ObjectRule kInstancingRule{"instancing", kInstancing};

constexpr std::array<std::string_view, 3> kPackedModes{"ATTRIBUTES", "TRIANGLES", "INDICES"};
constexpr std::array<std::string_view, 4> kPackedFilters{"NONE", "OCTAHEDRAL", "QUATERNION",
                                                         "EXPONENTIAL"};
constexpr std::array kPackedView{
    index("buffer", "buffers").must(),        integer("byteOffset").at_least(0),
    integer("byteLength").at_least(1).must(), integer("byteStride").at_least(1).at_most(256).must(),
    integer("count").at_least(1).must(),      one_of("mode", kPackedModes).must(),
    one_of("filter", kPackedFilters)};
constexpr ObjectRule kPackedViewRule{"packedView", kPackedView};
constexpr std::array kFallback{boolean("fallback")};
constexpr ObjectRule kFallbackRule{"fallbackBuffer", kFallback};

// --- variants and the rest
// ------------------------------------------------------------------------

constexpr std::array kVariant{string("name").must()};
constexpr ObjectRule kVariantRule{"variant", kVariant};
constexpr std::array kVariants{object("variants", kVariantRule).list_of().must()};
constexpr ObjectRule kVariantsRule{"variants", kVariants};
constexpr std::array kMapping{
    index("variants", "/extensions/KHR_materials_variants/variants").list_of().once().must(),
    index("material", "materials").must(), string("name")};
constexpr ObjectRule kMappingRule{"mapping", kMapping};
constexpr std::array kMappings{object("mappings", kMappingRule).list_of().must()};
constexpr ObjectRule kMappingsRule{"mappings", kMappings};

constexpr std::array kVisibility{boolean("visible")};
constexpr ObjectRule kVisibilityRule{"visibility", kVisibility};
constexpr std::array kTransform{number("offset").list_of(2), number("rotation"),
                                number("scale").list_of(2), integer("texCoord").at_least(0)};
constexpr ObjectRule kTransformRule{"textureTransform", kTransform};
constexpr ObjectRule kNothingRule{"nothing", {}};

constexpr std::array kExtensions{
    ExtensionRule{"EXT_mesh_gpu_instancing", "node", &kInstancingRule},
    ExtensionRule{"EXT_meshopt_compression", "buffer", &kFallbackRule},
    ExtensionRule{"EXT_meshopt_compression", "bufferView", &kPackedViewRule},
    ExtensionRule{"EXT_texture_webp", "texture", &kImageSourceRule},
    ExtensionRule{"KHR_animation_pointer", "animationTarget", &kPointerRule},
    ExtensionRule{"KHR_lights_punctual", "glTF", &kLightsRule},
    ExtensionRule{"KHR_lights_punctual", "node", &kLightOfNodeRule},
    ExtensionRule{"KHR_materials_anisotropy", "material", &kAnisotropyRule},
    ExtensionRule{"KHR_materials_clearcoat", "material", &kClearcoatRule},
    ExtensionRule{"KHR_materials_dispersion", "material", &kDispersionRule},
    ExtensionRule{"KHR_materials_emissive_strength", "material", &kEmissiveStrengthRule},
    ExtensionRule{"KHR_materials_ior", "material", &kIorRule},
    ExtensionRule{"KHR_materials_iridescence", "material", &kIridescenceRule},
    ExtensionRule{"KHR_materials_pbrSpecularGlossiness", "material", &kSpecularGlossinessRule},
    ExtensionRule{"KHR_materials_sheen", "material", &kSheenRule},
    ExtensionRule{"KHR_materials_specular", "material", &kSpecularRule},
    ExtensionRule{"KHR_materials_transmission", "material", &kTransmissionRule},
    ExtensionRule{"KHR_materials_unlit", "material", &kNothingRule},
    ExtensionRule{"KHR_materials_variants", "glTF", &kVariantsRule},
    ExtensionRule{"KHR_materials_variants", "primitive", &kMappingsRule},
    ExtensionRule{"KHR_materials_volume", "material", &kVolumeRule},
    ExtensionRule{"KHR_mesh_quantization", "", nullptr},
    ExtensionRule{"KHR_node_visibility", "node", &kVisibilityRule},
    ExtensionRule{"KHR_texture_basisu", "texture", &kImageSourceRule},
    ExtensionRule{"KHR_texture_transform", "textureInfo", &kTransformRule}};

}  // namespace

std::span<const ExtensionRule> extension_rules() {
  return kExtensions;
}

}  // namespace lueur::conformance
