import { PLAYER_COLOURS, PLAYER_SHAPES, type ShapeAndColour } from '../players/player-identity.ts';

/** A mark that a client has. */
export interface NamedMark {
  readonly name: string;
  readonly mark: ShapeAndColour;
}

/** Most people who are named in the sentence. */
const MAX_NAMED = 2;

/** `blue triangle`. */
export function markWord({ shape, colour }: ShapeAndColour): string {
  return `${PLAYER_COLOURS[colour - 1] ?? ''} ${PLAYER_SHAPES[shape - 1] ?? 'mark'}`.trim();
}

export function isSameMark(a: ShapeAndColour, b: ShapeAndColour): boolean {
  return a.shape === b.shape && a.colour === b.colour;
}

/** Who has this mark, or which are taken: one sentence or two. */
export function takenSentence(mark: ShapeAndColour, taken: readonly NamedMark[]): string {
  const same = taken.find((one) => isSameMark(one.mark, mark));
  if (same !== undefined) return `${same.name || 'Another person'} is the ${markWord(mark)}, too.`;
  if (taken.length === 0) return 'All are free.';
  if (taken.length > MAX_NAMED) return `${taken.length} are taken. This one is free.`;
  const words = taken.map((one) => `${one.name || 'Another person'} is the ${markWord(one.mark)}`);
  return `${words.join(', ')}. All others are free.`;
}
