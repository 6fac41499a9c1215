import type { Photo } from '../../net/index.ts';
import {
  gainsOf,
  ordinal,
  thingOf,
  type Area,
  type HuntPhoto,
  type HuntState,
  type Player,
  type Seat,
} from '../../sim/index.ts';

/** One card on the line. */
export interface HuntCard {
  readonly seat: Seat;
  readonly name: string;
  readonly status: 'hunting' | 'looking' | 'found' | 'wrong';
  /** Behind the name, such as `1st +3`. */
  readonly note: string;
  /** The photo, if the player shows it. */
  readonly photo?: Photo;
  /** The detected object in the photo with its score in percent, such as `cup 97`. */
  readonly mark?: string;
  readonly area?: Area;
  readonly isBest: boolean;
  readonly isBot: boolean;
  readonly isAway: boolean;
}

export const MAX_CARDS = 12;
/** Points of a place, as long as the best photo is not decided. */
const PROVISIONAL = ['+3', '+2'];
/** Times are floating-point numbers on their way. */
const SAME_MS = 2;

/**
 * The cards of those who hunt, in the order of their seats.
 *
 * @param photos by client id
 * @param startsAtMs of the round, milliseconds since the Unix epoch, master's clock
 */
export function huntCards(
  { hunt, decided }: HuntState,
  players: readonly Player[],
  photos: ReadonlyMap<string, Photo>,
  startsAtMs: number,
): readonly HuntCard[] {
  if (!hunt) return [];
  const gains = decided?.gains ?? gainsOf(hunt);
  const { name: thing } = thingOf(hunt.label);
  const noteOf = (seat: Seat, photo: HuntPhoto | undefined, isAway: boolean): string => {
    const gain = gains[seat];
    if (gain) {
      const points = decided ? `+${gain.points}` : (PROVISIONAL[gain.place - 1] ?? '+1');
      return `${ordinal(gain.place)} ${points}`;
    }
    if (photo?.verdict === 'wrong') return `not ${thing}`;
    if (isAway) return 'away';
    if (decided) return 'not found';
    return photo ? 'looking' : 'hunting';
  };
  return [...hunt.hunters]
    .sort((a, b) => a - b)
    .flatMap((seat) => {
      const player = players.find((one) => one.seat === seat);
      if (!player) return [];
      const taken = hunt.photos[seat];
      const isAway = player.awaySinceMs !== undefined;
      const shown = player.key === undefined ? undefined : photos.get(player.key);
      const takenAtMs = startsAtMs + (taken?.claimedAtMs ?? taken?.atMs ?? NaN);
      const isOfNow = taken && shown && Math.abs(shown.atMs - takenAtMs) < SAME_MS;
      return {
        seat,
        name: player.name,
        status: taken?.verdict ?? 'hunting',
        note: noteOf(seat, taken, isAway),
        ...(isOfNow && { photo: shown }),
        ...(isOfNow && markOf(taken)),
        isBest: gains[seat]?.isBest === true,
        isBot: player.key === undefined,
        isAway,
      };
    });
}

function markOf({ text, score, area }: HuntPhoto): { mark?: string; area?: Area } {
  if (!area || text === '') return {};
  return { mark: `${text} ${Math.round(score * 100)}`, area };
}
