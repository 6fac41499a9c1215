import type { Answer, Area } from '../sim/index.ts';

/** A record of `object2D`, as it comes from the runtime; anybody who has joined may publish one. */
export interface AnswerRecord {
  readonly object2D?: {
    readonly id?: string;
    readonly pose?: { readonly position?: { readonly x?: number; readonly y?: number } };
    readonly size?: { readonly x?: number; readonly y?: number };
    readonly userDataJson?: string;
  };
}

const MAX_CHARACTERS = 30;
const MAX_JSON_CHARACTERS = 200;
/** A phone may look so long at a photo, milliseconds. */
const OLDEST_MS = 10_000;
/** Answers from further in the future are left out. */
const MAX_AHEAD_MS = 2000;

/**
 * Parses the answer of a phone; undefined for a record that is not one. Texts are lower-case words, like class names.
 *
 * @param nowMs milliseconds since the Unix epoch
 * @param startsAtMs of the round, on the same clock
 */
export function readAnswer(
  record: AnswerRecord | undefined,
  nowMs: number,
  startsAtMs: number,
): Answer | undefined {
  const object = record?.object2D;
  const text = object?.id ?? '';
  const data = readData(object?.userDataJson);
  if (!data || text.length > MAX_CHARACTERS || !/^[a-z ]*$/.test(text)) return undefined;
  const { score, atMs } = data;
  if (!(atMs <= nowMs + MAX_AHEAD_MS && atMs > nowMs - OLDEST_MS)) return undefined;
  if (!(score >= 0 && score <= 1)) return undefined;
  const area = readArea(object!);
  return { text, score, atMs: atMs - startsAtMs, ...(area && { area }) };
}

function readData(text = ''): { readonly score: number; readonly atMs: number } | undefined {
  if (text === '' || text.length > MAX_JSON_CHARACTERS) return undefined;
  try {
    const { score, atMs } = JSON.parse(text) as { score?: unknown; atMs?: unknown };
    return typeof score === 'number' && typeof atMs === 'number' ? { score, atMs } : undefined;
  } catch {
    return undefined;
  }
}

function readArea({ pose, size }: NonNullable<AnswerRecord['object2D']>): Area | undefined {
  const { x = NaN, y = NaN } = pose?.position ?? {};
  const { x: width = NaN, y: height = NaN } = size ?? {};
  const isInside = x >= 0 && y >= 0 && x + width <= 1.001 && y + height <= 1.001;
  return isInside && width > 0 && height > 0 ? { x, y, width, height } : undefined;
}
