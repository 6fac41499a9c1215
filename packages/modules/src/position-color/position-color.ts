import { defineProcessingModule } from '@ubii/pm-sandbox';
import type { NumberRecord } from '../number-record.ts';

/** Converts a position to a colour: the hue from x, the lightness from y. */
export const positionColor = defineProcessingModule({
  name: 'position-color',
  description: 'Converts a position to a colour (hue, lightness).',
  tags: ['color', 'vector', 'pointer', 'convert'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  inputs: {
    position: {
      format: 'vector2',
      description: 'Position, 0 to 1, origin top left: x is the hue, y the lightness.',
    },
    saturation: {
      format: 'double',
      default: 0.8,
      description: 'Saturation of the colour, 0 to 1; 0 is grey.',
    },
  },
  outputs: {
    color: { format: 'color', description: 'Opaque sRGB colour, each part from 0 to 1.' },
    hex: { format: 'string', description: 'The same colour as #rrggbb.' },
  },
  mode: { triggerOnInput: {} },
  onProcessing(_deltaTimeMs, inputs) {
    const read = {
      value(record: NumberRecord | undefined) {
        return record?.double ?? record?.float ?? record?.int32;
      },
      // A number that is not finite counts as missing.
      number(record: NumberRecord | undefined, fallback: number) {
        const value = this.value(record);
        return Number.isFinite(value) ? Math.min(1, Math.max(0, value!)) : fallback;
      },
    };
    const position = inputs.position?.vector2;
    if (!position || !Number.isFinite(position.x) || !Number.isFinite(position.y)) return undefined;
    const saturation = read.number(inputs.saturation, 0.8);
    // The hue is a circle: positions outside the surface wrap around.
    const hue = ((position.x % 1) + 1) % 1;
    const lightness = 0.85 - 0.65 * Math.min(1, Math.max(0, position.y));

    // HSL to sRGB as in CSS Color Module Level 4, section 7.1.
    const chroma = saturation * Math.min(lightness, 1 - lightness);
    const channels = [0, 8, 4].map((n) => {
      const k = (n + hue * 12) % 12;
      return lightness - chroma * Math.max(-1, Math.min(k - 3, 9 - k, 1));
    });
    const [r = 0, g = 0, b = 0] = channels;
    const hex = channels.map((part) =>
      Math.round(part * 255)
        .toString(16)
        .padStart(2, '0'),
    );
    return {
      outputs: { color: { color: { r, g, b, a: 1 } }, hex: { string: `#${hex.join('')}` } },
    };
  },
});
