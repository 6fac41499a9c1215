import { duelGame } from './duel/duel-game.ts';
import { hillGame } from './hill/hill-game.ts';
import { huntGame } from './hunt/hunt-game.ts';
import { quizGame } from './quiz/quiz-game.ts';
import { raceGame } from './race/race-game.ts';

/** The games that are decided by rules alone. */
export const GAMES = {
  race: raceGame,
  hill: hillGame,
  hunt: huntGame,
  duel: duelGame,
  quiz: quizGame,
} as const;
export type GameId = keyof typeof GAMES;
