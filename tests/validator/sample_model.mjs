// SPDX-License-Identifier: MIT
// A small model that has one of everything that the exporter writes and no built-in scene has:
// skins, morph targets, splines, vertex colours, a second set of coordinates, transforms of
// textures, unlit and masked materials, a matrix with shear.

// Red, translucent green, blue and transparent white: 2x2 pixels.
const kPicture =
  'data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAYAAABytg0kAAAAFUlEQVR42mP47+DwHwgbGIA0CDAA' +
  'AFVTCfkhtsnpAAAAAElFTkSuQmCC';

const kFloat = 5126;
const kByte = 5121;
const kShort = 5123;
const kComponents = {SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16};
const kVertices = 34962;
const kIndices = 34963;

// Collects accessors, each with a view of its own into one buffer.
class Arrays {
  accessors = [];
  views = [];
  #bytes = [];

  // Returns the accessor's index.
  add(values, type, {component = kFloat, target, normalized, range} = {}) {
    const array = {[kFloat]: Float32Array, [kByte]: Uint8Array, [kShort]: Uint16Array}[component];
    const bytes = new Uint8Array(array.from(values).buffer);
    this.views.push({buffer: 0, byteOffset: this.#bytes.length, byteLength: bytes.length, target});
    this.#bytes.push(...bytes);
    while (this.#bytes.length % 4 !== 0) this.#bytes.push(0);
    const width = kComponents[type];
    const accessor = {
      bufferView: this.views.length - 1,
      componentType: component,
      count: values.length / width,
      type,
      normalized,
    };
    if (range) {
      const column = (c) => values.filter((_, i) => i % width === c);
      const columns = [...Array(width).keys()].map(column);
      accessor.min = columns.map((c) => Math.min(...c));
      accessor.max = columns.map((c) => Math.max(...c));
    }
    return this.accessors.push(accessor) - 1;
  }

  buffer() {
    return {
      byteLength: this.#bytes.length,
      uri: 'data:application/octet-stream;base64,' + Buffer.from(this.#bytes).toString('base64'),
    };
  }
}

const times = (n, values) => Array(n).fill(values).flat();

// A square of two triangles, one a primitive: the lower one painted, the upper one unlit.
function squareMesh(arrays) {
  const vertex = (values, type, options) =>
    arrays.add(values, type, {target: kVertices, ...options});
  const corners = [0, 0, 1, 0, 0, 1, 1, 1];
  const flat = (z) => [0, 1, 2, 3].flatMap((i) => [corners[2 * i], corners[2 * i + 1], z]);
  const attributes = {
    POSITION: vertex(flat(0), 'VEC3', {range: true}),
    NORMAL: vertex(times(4, [0, 0, 1]), 'VEC3'),
    TANGENT: vertex(times(4, [1, 0, 0, 1]), 'VEC4'),
    TEXCOORD_0: vertex(corners, 'VEC2'),
    TEXCOORD_1: vertex(
      corners.map((c) => 1 - c / 2),
      'VEC2',
    ),
    COLOR_0: vertex([255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 128], 'VEC4', {
      component: kByte,
      normalized: true,
    }),
    JOINTS_0: vertex([0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0], 'VEC4', {component: kByte}),
    WEIGHTS_0: vertex([1, 0, 0, 0, 1, 0, 0, 0, 0.25, 0.75, 0, 0, 0.5, 0.5, 0, 0], 'VEC4'),
  };
  const targets = [
    {
      POSITION: vertex([0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1], 'VEC3', {range: true}),
      NORMAL: vertex(times(4, [-0.5, 0, 0]), 'VEC3'),
    },
    {POSITION: vertex(times(4, [0, 0, 2]), 'VEC3', {range: true})},
  ];
  const primitive = (indices, material) => ({
    attributes,
    targets,
    material,
    indices: arrays.add(indices, 'SCALAR', {component: kShort, target: kIndices}),
  });
  return {
    name: 'square',
    primitives: [primitive([0, 1, 2], 0), primitive([2, 1, 3], 1)],
    weights: [0.5, 0],
  };
}

// Its second set of coordinates is zero everywhere, and its material asks for it all the same.
function triangleMesh(arrays) {
  const vertex = (values, type, options) =>
    arrays.add(values, type, {target: kVertices, ...options});
  const attributes = {
    POSITION: vertex([0, 0, 0, 1, 0, 0, 0, 1, 0], 'VEC3', {range: true}),
    TEXCOORD_0: vertex([0, 0, 1, 0, 0, 1], 'VEC2'),
    TEXCOORD_1: vertex(times(6, [0]), 'VEC2'),
  };
  return {name: 'triangle', primitives: [{attributes, material: 2}]};
}

function materials() {
  const texture = (index, texCoord, transform) => ({
    index,
    texCoord,
    extensions: transform && {KHR_texture_transform: transform},
  });
  return [
    {
      name: 'painted',
      pbrMetallicRoughness: {
        baseColorTexture: texture(0, 1, {offset: [0.25, -0.5], rotation: 0.7, scale: [2, 3]}),
        metallicRoughnessTexture: texture(0, 0, {scale: [-1, 1]}),
      },
      normalTexture: {...texture(1, 0), scale: 0.5},
      emissiveFactor: [1, 0.5, 0.25],
      emissiveTexture: texture(0, 1),
      extensions: {
        KHR_materials_emissive_strength: {emissiveStrength: 20},
        KHR_materials_specular: {specularFactor: 0.25},
      },
    },
    {
      name: 'unlit',
      pbrMetallicRoughness: {baseColorFactor: [0.2, 0.4, 0.6, 0.8]},
      alphaMode: 'MASK',
      alphaCutoff: 0.25,
      doubleSided: true,
      extensions: {KHR_materials_unlit: {}},
    },
    {
      name: 'plain',
      pbrMetallicRoughness: {baseColorTexture: texture(0, 0)},
      emissiveFactor: [1, 1, 1],
      emissiveTexture: texture(0, 1),
    },
  ];
}

// Splines have a tangent, a value and a tangent for each of two keys.
function animation(arrays, {joint, moved, morphed}) {
  const input = arrays.add([0, 2], 'SCALAR', {range: true});
  const still = [0, 0, 0, 0];
  const channels = [
    [
      joint,
      'rotation',
      'CUBICSPLINE',
      [...still, 0, 0, 0, 1, ...still, ...still, 0, 0, 0.6, 0.8, ...still],
      'VEC4',
    ],
    [joint, 'translation', 'LINEAR', [0, 1, 0, 0, 1.5, 0], 'VEC3'],
    [moved, 'scale', 'STEP', [1, 1, 1, 2, 2, 2], 'VEC3'],
    [
      moved,
      'translation',
      'CUBICSPLINE',
      [...times(9, [0]), ...[0, 0, 0, 1, 2, 3, 0, 0, 0]],
      'VEC3',
    ],
    [morphed, 'weights', 'CUBICSPLINE', [0, 0, 0, 0, 3, 0, 0, 0, 1, 0.5, 0, 0], 'SCALAR'],
  ];
  return {
    samplers: channels.map(([, , interpolation, values, type]) => ({
      input,
      interpolation,
      output: arrays.add(values, type),
    })),
    channels: channels.map(([node, path], sampler) => ({sampler, target: {node, path}})),
  };
}

export function sampleModel() {
  const arrays = new Arrays();
  const movedBy = (y) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, y, 0, 1];
  const bind = arrays.add([...movedBy(0), ...movedBy(-1)], 'MAT4');
  // Two skins over the same two joints; a joint stands on the other.
  const nodes = [
    {name: 'hip', translation: [0, 0.5, 0], children: [1]},
    {name: 'knee', translation: [0, 1, 0]},
    {name: 'skinned', mesh: 0, skin: 0},
    {name: 'skinned, too', mesh: 0, skin: 1, weights: [0, 1]},
    {
      name: 'mesh, camera and light',
      mesh: 1,
      camera: 0,
      extensions: {KHR_lights_punctual: {light: 0}},
    },
    {name: 'shear', mesh: 1, matrix: [1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 3, 0, 0, 1]},
    {name: 'sun', rotation: [-0.6, 0, 0, 0.8], extensions: {KHR_lights_punctual: {light: 1}}},
    {name: 'lamp', extensions: {KHR_lights_punctual: {light: 2}}},
  ];
  return {
    asset: {version: '2.0'},
    extensionsUsed: [
      'KHR_lights_punctual',
      'KHR_materials_emissive_strength',
      'KHR_materials_specular',
      'KHR_materials_unlit',
      'KHR_texture_transform',
    ],
    scene: 0,
    scenes: [{nodes: [0, 2, 3, 4, 5, 6, 7]}],
    nodes,
    meshes: [squareMesh(arrays), triangleMesh(arrays)],
    skins: [
      {joints: [0, 1], inverseBindMatrices: bind},
      {joints: [1, 0], inverseBindMatrices: bind},
    ],
    animations: [animation(arrays, {joint: 1, moved: 4, morphed: 2})],
    materials: materials(),
    textures: [
      {sampler: 0, source: 0},
      {sampler: 1, source: 0},
    ],
    samplers: [{wrapS: 33648, wrapT: 33071, magFilter: 9728}, {}],
    images: [{uri: kPicture}],
    cameras: [{type: 'perspective', perspective: {yfov: 0.8, znear: 0.1, zfar: 50}}],
    extensions: {
      KHR_lights_punctual: {
        lights: [
          {type: 'spot', intensity: 100, spot: {innerConeAngle: 0.1, outerConeAngle: 0.2}},
          {type: 'directional', intensity: 3},
          {type: 'point', color: [1, 0.5, 0.25]},
        ],
      },
    },
    accessors: arrays.accessors,
    bufferViews: arrays.views,
    buffers: [arrays.buffer()],
  };
}
