import { defineProcessingModule } from '@ubii/pm-sandbox';
import type { NumberRecord } from '../number-record.ts';

/** Generates images without a camera: a disc that moves over bars and a gradient. */
export const testPicture = defineProcessingModule({
  name: 'test-picture',
  description: 'Generates a moving test image.',
  tags: ['source', 'generator', 'image'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  inputs: {
    width: { format: 'int32', default: 96, description: 'Width of the image, 16 to 320 pixels.' },
    height: { format: 'int32', default: 54, description: 'Height of the image, 16 to 240 pixels.' },
    turnsPerSecond: {
      format: 'double',
      default: 0.2,
      description: 'Rounds of the disc per second, 0 to 10.',
    },
  },
  outputs: {
    picture: { format: 'image2D', description: 'The image as raw pixels, RGB8.' },
  },
  mode: { frequency: { hertz: 12 } },
  createState: () => ({ turns: 0 }),
  onProcessing(deltaTimeMs, inputs, state) {
    const read = {
      value(record: NumberRecord | undefined) {
        return record?.double ?? record?.float ?? record?.int32;
      },
      // A number that is not finite counts as missing.
      number(record: NumberRecord | undefined, fallback: number, min: number, max: number) {
        const value = this.value(record);
        return Number.isFinite(value) ? Math.min(max, Math.max(min, value!)) : fallback;
      },
    };
    const width = Math.round(read.number(inputs.width, 96, 16, 320));
    const height = Math.round(read.number(inputs.height, 54, 16, 240));
    const turnsPerSecond = read.number(inputs.turnsPerSecond, 0.2, 0, 10);
    state.turns = (state.turns + (turnsPerSecond * deltaTimeMs) / 1000) % 1;

    const angle = 2 * Math.PI * state.turns;
    const discX = width * (0.5 + 0.34 * Math.cos(angle));
    const discY = height * (0.5 + 0.26 * Math.sin(2 * angle));
    const radius = height * 0.22;
    const barWidth = width / 8;
    const data = new Uint8Array(width * height * 3);
    let at = 0;
    for (let y = 0; y < height; y++) {
      const shade = 40 + (90 * y) / height;
      for (let x = 0; x < width; x++) {
        const isDisc = (x - discX) ** 2 + (y - discY) ** 2 < radius ** 2;
        const isBar = y > height * 0.7 && Math.floor(x / barWidth) % 2 === 0;
        data[at++] = isDisc ? 250 : isBar ? 30 : shade;
        data[at++] = isDisc ? 200 : isBar ? 120 : shade + 20;
        data[at++] = isDisc ? 90 : isBar ? 170 : shade + 60;
      }
    }
    // 1 is RGB8.
    return { outputs: { picture: { image2D: { width, height, dataFormat: 1, data } } } };
  },
});
