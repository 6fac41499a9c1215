// The asset set `party`: what the modules of the games call, as one script.

export { playRound } from './play-round.ts';
