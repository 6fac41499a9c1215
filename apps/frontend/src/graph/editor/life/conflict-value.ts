import type { ProcessingMode } from '@ubii/proto';
import { modeWords } from '../../../sessions/words/mode-words.ts';

const MAX_LENGTH = 60;
const MODES: ReadonlySet<string> = new Set(['frequency', 'triggerOnInput', 'lockstep', 'free']);

/** Returns one side of a conflict as a text that fits on a button. */
export function conflictValue(value: unknown): string {
  const text = plain(value);
  return text.length > MAX_LENGTH ? `${text.slice(0, MAX_LENGTH - 1)}…` : text;
}

function plain(value: unknown): string {
  if (value === undefined) return 'deleted';
  if (value === '') return 'empty';
  if (typeof value !== 'object' || value === null) return String(value);
  const keys = Object.keys(value);
  if (keys.some((key) => MODES.has(key))) return modeWords(value as ProcessingMode);
  if ('kind' in value && 'id' in value) return 'there';
  return JSON.stringify(value);
}
