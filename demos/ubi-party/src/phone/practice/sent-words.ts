import { capitalised } from '@ubii/words';

import type { Controller } from '../../sim/index.ts';
import type { Steering } from '../pads/stick.ts';

/** The input that a phone would send now, in words: a headline of at most 16 characters, and the button. */
export function sentWords(
  { steering, button }: Pick<Controller, 'steering' | 'button'>,
  { x, y }: Steering,
  isDown: boolean,
): { readonly headline: string; readonly sentence: string } {
  const sentence = `${button} is ${isDown ? 'pressed' : 'not pressed'}.`;
  if (steering === 'none') return { headline: isDown ? 'Pressed' : 'Not pressed', sentence };
  return { headline: steering === 'wheel' ? wheelWords(x) : stickWords(x, y), sentence };
}

function wheelWords(x: number): string {
  return x === 0 ? 'Straight' : `${x < 0 ? 'Left' : 'Right'} ${percent(x)}`;
}

function stickWords(x: number, y: number): string {
  const length = Math.min(1, Math.hypot(x, y));
  if (length === 0) return 'Middle';
  // Of eight directions the nearest
  const upward = y > 0.38 * length ? 'up' : y < -0.38 * length ? 'down' : '';
  const sideways = x > 0.38 * length ? 'right' : x < -0.38 * length ? 'left' : '';
  const words = [upward, sideways].filter((word) => word !== '').join(' ');
  return `${capitalised(words)} ${percent(length)}`;
}

const percent = (share: number): string => `${Math.round(Math.abs(share) * 100)} %`;
