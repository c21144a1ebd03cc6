// SPDX-License-Identifier: MIT
// From linear light to code values, as src/image/tone_map.cpp does it; the page's test holds the
// two against each other. Each curve takes and leaves three numbers in `v`: in linear Rec.709, out
// linear too (`encoded` false) or display-encoded.

const kBrightest = 65504;

const clamp01 = (value) => (value > 0 ? Math.min(value, 1) : 0);

function multiply(m, v) {
  const [r, g, b] = v;
  for (let row = 0; row < 3; ++row) v[row] = m[row][0] * r + m[row][1] * g + m[row][2] * b;
}

// Stephen Hill's fit of the RRT and ODT of ACES.
const kRrtFromRec709 = [
  [0.59719, 0.35458, 0.04823],
  [0.076, 0.90834, 0.01566],
  [0.0284, 0.13383, 0.83777],
];
const kRec709FromOdt = [
  [1.60475, -0.53108, -0.07367],
  [-0.10208, 1.10813, -0.00605],
  [-0.00327, -0.07276, 1.07602],
];

function aces(v) {
  multiply(kRrtFromRec709, v);
  for (let c = 0; c < 3; ++c) {
    const x = v[c];
    v[c] = (x * (x + 0.0245786) - 0.000090537) / (x * (0.983729 * x + 0.432951) + 0.238081);
  }
  multiply(kRec709FromOdt, v);
}

// Troy Sobotka's AgX with Benjamin Wrensch's polynomial; its result is display-encoded.
const kAgxInset = [
  [0.842479062253094, 0.0784335999999992, 0.0792237451477643],
  [0.0423282422610123, 0.878468636469772, 0.0791661274605434],
  [0.0423756549057051, 0.0784336, 0.879142973793104],
];
const kAgxOutset = [
  [1.19687900512017, -0.0980208811401368, -0.0990297440797205],
  [-0.0528968517574562, 1.15190312990417, -0.0989611768448433],
  [-0.0529716355144438, -0.0980434501171241, 1.15107367264116],
];
const kAgxPolynomial = [15.5, -40.14, 31.96, -6.868, 0.4298, 0.1191, -0.00232];
const kAgxMinEv = -12.47393;
const kAgxMaxEv = 4.026069;

function agx(v) {
  multiply(kAgxInset, v);
  for (let c = 0; c < 3; ++c) {
    const ev = v[c] > 0 ? Math.min(Math.max(Math.log2(v[c]), kAgxMinEv), kAgxMaxEv) : kAgxMinEv;
    const t = (ev - kAgxMinEv) / (kAgxMaxEv - kAgxMinEv);
    v[c] = kAgxPolynomial.reduce((y, coefficient) => y * t + coefficient, 0);
  }
  multiply(kAgxOutset, v);
}

// Khronos PBR Neutral 1.0.
function khronosNeutral(v) {
  const f90 = 0.04;
  const start = 0.8 - f90;
  const desaturation = 0.15;
  const x = Math.min(v[0], v[1], v[2]);
  const offset = x < 2 * f90 ? x - (x * x) / (4 * f90) : f90;
  v[0] -= offset;
  v[1] -= offset;
  v[2] -= offset;
  const peak = Math.max(v[0], v[1], v[2]);
  if (peak < start) return;
  const range = 1 - start;
  const newPeak = 1 - (range * range) / (peak + range - start);
  const toWhite = 1 - 1 / (desaturation * (peak - newPeak) + 1);
  const toPeak = newPeak / peak;
  for (let c = 0; c < 3; ++c) v[c] = v[c] * toPeak + (newPeak - v[c] * toPeak) * toWhite;
}

const kToneMaps = {
  'khronos-neutral': {curve: khronosNeutral, encoded: false},
  aces: {curve: aces, encoded: false},
  agx: {curve: agx, encoded: true},
  none: {curve: () => {}, encoded: false},
};

// sRGB code values of linear light in [0, 1]. kCodeStarts[k] is the least value that rounds to code
// k or more; kCodeGuess leads from the value to a code that is at most a few too small.
const kCodeStarts = Float64Array.from({length: 257}, (_, k) => {
  const encoded = (k - 0.5) / 255;
  if (k === 0) return -Infinity;
  if (k === 256) return Infinity;
  return encoded <= 0.04045 ? encoded / 12.92 : ((encoded + 0.055) / 1.055) ** 2.4;
});
const kCodeGuess = new Uint8Array(4097);
for (let i = 0, code = 0; i <= 4096; ++i) {
  while (kCodeStarts[code + 1] <= i / 4096) ++code;
  kCodeGuess[i] = code;
}

function srgbCode(linear) {
  const value = clamp01(linear);
  let code = kCodeGuess[(value * 4096) | 0];
  while (value >= kCodeStarts[code + 1]) ++code;
  return code;
}

// Writes the display's picture of linear colours, three a pixel, as RGBA. `codes` are what the page
// carries and `light` the value of each code.
function toDisplay(codes, light, exposureEv, toneMapName, rgba) {
  const {curve, encoded} = kToneMaps[toneMapName];
  const scale = 2 ** exposureEv;
  const exposed = Float64Array.from(light, (value) => Math.min(value * scale, kBrightest));
  const v = [0, 0, 0];
  for (let i = 0, o = 0; i < codes.length; i += 3, o += 4) {
    v[0] = exposed[codes[i]];
    v[1] = exposed[codes[i + 1]];
    v[2] = exposed[codes[i + 2]];
    curve(v);
    for (let c = 0; c < 3; ++c)
      rgba[o + c] = encoded ? Math.round(clamp01(v[c]) * 255) : srgbCode(v[c]);
    rgba[o + 3] = 255;
  }
}
