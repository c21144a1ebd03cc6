// SPDX-License-Identifier: MIT
// Unpacks pictures; src/report/packed_picture.h has the format.

const canUnpack = () => 'DecompressionStream' in globalThis;

// The light of each code: the half float whose last bits were dropped.
function lightOfCodes(droppedBits) {
  return Float64Array.from({length: 0x7c00 >> droppedBits}, (_, code) => {
    const half = code << droppedBits;
    const exponent = half >> 10;
    const fraction = half & 0x3ff;
    return exponent === 0 ? fraction * 2 ** -24 : (1 + fraction / 1024) * 2 ** (exponent - 15);
  });
}

// The codes of the picture with this number, `channels` a pixel.
async function unpackPicture(number, width, height, channels) {
  const bytes = await inflate(byId(`picture-${number}`).textContent);
  const count = width * height;
  const codes = new Uint16Array(count * channels);
  const base = unpredict(bytes, 0, width, height);
  if (channels === 1) {
    codes.set(base);
    return codes;
  }
  const red = unpredict(bytes, 2 * count, width, height);
  const blue = unpredict(bytes, 4 * count, width, height);
  for (let i = 0, o = 0; i < count; ++i, o += 3) {
    codes[o] = base[i] + red[i];
    codes[o + 1] = base[i];
    codes[o + 2] = base[i] + blue[i];
  }
  return codes;
}

async function inflate(base64) {
  const text = atob(base64);
  const packed = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) packed[i] = text.charCodeAt(i);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Adds to what prediction missed what it predicts.
function unpredict(bytes, start, width, height) {
  const count = width * height;
  const plane = new Int32Array(count);
  for (let y = 0, i = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x, ++i) {
      const folded = bytes[start + i] | (bytes[start + count + i] << 8);
      const miss = folded & 1 ? -((folded + 1) >> 1) : folded >> 1;
      plane[i] = miss + predicted(plane, i, x, y, width);
    }
  }
  return plane;
}

function predicted(plane, i, x, y, width) {
  if (x === 0) return y === 0 ? 0 : plane[i - width];
  const left = plane[i - 1];
  if (y === 0) return left;
  const above = plane[i - width];
  const slope = left + above - plane[i - width - 1];
  return left < above
    ? Math.min(Math.max(slope, left), above)
    : Math.min(Math.max(slope, above), left);
}

// All pictures of the page, unpacked when first asked for, one after the other.
class PictureStore {
  constructor({size, dropped_bits: droppedBits}) {
    [this.width, this.height] = size;
    this.light = lightOfCodes(droppedBits);
    this.unpacked = new Map();
    this.waiting = new Map();
    this.last = Promise.resolve();
  }

  // The codes, or undefined while they are packed.
  codes(number) {
    return this.unpacked.get(number);
  }

  unpack(number, channels) {
    if (this.waiting.has(number)) return this.waiting.get(number);
    this.last = this.last.then(async () => {
      this.unpacked.set(number, await unpackPicture(number, this.width, this.height, channels));
      byId(`picture-${number}`).remove(); // what was unpacked needs no second copy
    });
    this.waiting.set(number, this.last);
    return this.last;
  }
}
