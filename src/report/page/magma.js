// SPDX-License-Identifier: MIT
// The colour map magma (Nathaniel Smith and Stéfan van der Walt, CC0) at 33 places, linear between
// them: within 2 code values of the original's 256.
const kMagmaPlaces = (
  '000004 030312 0a0822 130d34 1d1147 29115a 36106b 440f76 51127c 5d177f 691c81 ' +
  '762181 822681 8f2a81 9c2e7f a9337d b6377a c33b75 cf4070 db476a e65164 ee5c5e f46a5c f9785d ' +
  'fb8861 fd9668 fea571 feb47b fec287 fed194 fde0a1 fceeb0 fcfdbf'
)
  .split(' ')
  .map((hex) => [0, 2, 4].map((at) => parseInt(hex.slice(at, at + 2), 16)));

// 256 colours, RGB.
const kMagma = Uint8Array.from({length: 256 * 3}, (_, i) => {
  const at = (Math.floor(i / 3) / 255) * (kMagmaPlaces.length - 1);
  const place = Math.min(Math.floor(at), kMagmaPlaces.length - 2);
  const [low, high] = [kMagmaPlaces[place][i % 3], kMagmaPlaces[place + 1][i % 3]];
  return Math.round(low + (high - low) * (at - place));
});

// Writes the map's picture as RGBA; `fullScale` and more is the brightest colour.
function toMagma(codes, light, fullScale, rgba) {
  const colors = Uint8Array.from(light, (value) =>
    Math.round(Math.min(value / fullScale, 1) * 255),
  );
  for (let i = 0, o = 0; i < codes.length; ++i, o += 4) {
    const color = colors[codes[i]] * 3;
    rgba[o] = kMagma[color];
    rgba[o + 1] = kMagma[color + 1];
    rgba[o + 2] = kMagma[color + 2];
    rgba[o + 3] = 255;
  }
}

const kMagmaGradient =
  'linear-gradient(to right, ' +
  kMagmaPlaces.map((rgb) => `rgb(${rgb.join(' ')})`).join(', ') +
  ')';
