import { describe, expect, it } from 'vitest';
import { fitText } from './fit-text.ts';

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

  it('keeps the part that differs in the middle', () => {
    const at = 'tracker_hand_'.length;
    const fit = (name: string): string => fitText(name, 120, ofTenPixels, at);
    expect(fit('tracker_hand_left_position')).toBe('tra…left_po…');
    expect(fit('tracker_hand_right_position')).toBe('tra…right_p…');
  });

  it('keeps beginning and end where they hold the difference', () => {
    expect(fitText('mouse_client_position', 100, ofTenPixels, 19)).toBe('mouse…tion');
    expect(fitText('mouse_client_position', 100, ofTenPixels, 2)).toBe('mouse…tion');
  });
});
