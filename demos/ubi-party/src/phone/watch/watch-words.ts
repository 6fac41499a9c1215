import { counted, plural } from '@ubii/words';

import type { Player, Room } from '../../sim/index.ts';
import { gameTexts, nextGame, placeTable } from '../round/useStanding.ts';

/** The states of a player, shown behind the name before a round. */
export function statusOf(player: Player, { leader }: Room): string[] {
  if (player.key === undefined) return ['bot'];
  if (player.awaySinceMs !== undefined) return ['away'];
  return [...(player.seat === leader ? ['leads'] : []), ...(player.isReady ? ['ready'] : [])];
}

/** The winners of the newest round; at the end of the tournament, those of the tournament. */
export function winnersOf(room: Room): string {
  const seats =
    room.phase === 'end'
      ? placeTable(room)
          .filter(({ place }) => place === 1)
          .map(({ player }) => player.seat)
      : (room.results.at(-1)?.places[0] ?? []);
  const names = seats.flatMap(
    (seat) => room.players.find((player) => player.seat === seat)?.name ?? [],
  );
  if (names.length === 0) return 'The round is over';
  if (names.length > 2) return `${names.length} players win`;
  return `${names.join(' and ')} ${plural(names.length, 'wins', 'win')}`;
}

/** One sentence about the current phase, for spectators. */
export function watchSentence(room: Room, game: string | undefined, playing: number): string {
  const { title } = gameTexts(game);
  const next = nextGame(room)?.title;
  const count = counted(playing, 'player');
  switch (room.phase) {
    case 'lobby':
      return playing === 0 ? 'No players yet.' : `${count}. The game has not started.`;
    case 'explanation':
      return `${title} starts soon with ${count}.`;
    case 'countdown':
      return `${title} starts now with ${count}.`;
    case 'play':
      return `${count} ${plural(playing, 'is', 'are')} playing.`;
    case 'podium':
      return next === undefined ? 'That was the last game.' : `Next: ${next}.`;
    case 'end':
      return 'The tournament is over.';
  }
}
