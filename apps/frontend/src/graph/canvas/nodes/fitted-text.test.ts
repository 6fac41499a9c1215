import { describe, expect, it } from 'vitest';
import { fitText } from './fitted-text.ts';

const ofTenPixels = (text: string): number => 10 * [...text].length;

describe('fitText', () => {
  it('leaves alone what fits', () => {
    expect(fitText('clock', 50, ofTenPixels)).toBe('clock');
  });

  it('keeps beginning and end of what does not', () => {
    expect(fitText('mouse_client_position', 100, ofTenPixels)).toBe('mouse…tion');
    expect(fitText('mouse_server_position', 110, ofTenPixels)).toBe('mouse…ition');
  });

  it('says at least that there is something', () => {
    expect(fitText('clock', 0, ofTenPixels)).toBe('…');
    expect(fitText('', 0, ofTenPixels)).toBe('');
  });

  it('takes no character apart', () => {
    expect(fitText('👋👋👋👋👋👋', 30, ofTenPixels)).toBe('👋…👋');
  });
});
