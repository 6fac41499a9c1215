import type { Recording, ReplayStartRequest } from '@ubii/proto';
import { oneLine } from '@ubii/words';
import { publicName } from '../recordings/public-name.ts';
import type { ReplayWish } from './replay-wish.ts';

/** What a replay is named by. */
interface NamedReplay {
  readonly request: Pick<ReplayStartRequest, 'isGhost' | 'name'>;
  readonly recording: Recording;
  readonly wish: Pick<ReplayWish, 'copies'>;
}

/** Returns the name of the client of one copy. [RP-1] [RP-30] */
export function replayName(
  { request, recording, wish }: NamedReplay,
  copy: number,
  maxCharacters: number,
): string {
  const kind = request.isGhost ? 'Ghost' : 'Replay';
  const name = request.name === '' ? `${kind} of ${publicName(recording)}` : request.name;
  return oneLine(wish.copies === 1 ? name : `${copy + 1}: ${name}`, maxCharacters);
}
