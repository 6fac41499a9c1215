import { GAMES, gameOf, type Controller, type Room } from '../../sim/index.ts';

/** Description of a game, as shown on a phone. */
export interface GameTexts {
  readonly title: string;
  readonly explanation: readonly string[];
  readonly explanationMs?: number;
  readonly controller: Controller;
}

/** A game that this page does not know yet is played with everything: the host is newer than the phone. */
const UNKNOWN: GameTexts = {
  title: 'Next game',
  explanation: ['The big screen explains this game.'],
  controller: { steering: 'stick', button: 'Press', isHeld: false },
};

export function gameTexts(id: string | undefined): GameTexts {
  const games: Readonly<Record<string, GameTexts>> = GAMES;
  return (id !== undefined && Object.hasOwn(games, id) ? games[id] : undefined) ?? UNKNOWN;
}

/** The game that is played now, or next. */
export function currentGame(room: Room | undefined): GameTexts {
  return gameTexts(room && gameOf(room));
}

/** The game after the podium; undefined: it was the last. */
export function nextGame({ games, results }: Room): GameTexts | undefined {
  const id = games[results.length];
  return id === undefined ? undefined : gameTexts(id);
}
