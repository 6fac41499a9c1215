import { describe, expect, it } from 'vitest';
import { fitText } from './fit-text.ts';

const ofTenPixels = (text: string): number => 10 * [...text].length;
const fit = (text: string, room: number): string => fitText(text, room, ofTenPixels);

describe('fitText', () => {
  it('leaves alone what fits', () => {
    expect(fit('clock', 50)).toBe('clock');
    expect(fit('/desk/clock', 110)).toBe('/desk/clock');
  });

  it('cuts a name at its end', () => {
    expect(fit('mouse_client_position', 100)).toBe('mouse_cli…');
    expect(fit('image-processing', 120)).toBe('image-proce…');
  });

  it('keeps the last level of a topic', () => {
    expect(fit('/web-page/position', 150)).toBe('/web-…/position');
    expect(fit('/web-page/position', 100)).toBe('…/position');
    expect(fit('/web-page/position', 80)).toBe('…/posit…');
    expect(fit('/position', 60)).toBe('/posi…');
  });

  it('says at least that there is something', () => {
    expect(fit('clock', 0)).toBe('…');
    expect(fit('', 0)).toBe('');
  });

  it('takes no character apart', () => {
    expect(fit('👋👋👋👋👋👋', 30)).toBe('👋👋…');
  });
});
