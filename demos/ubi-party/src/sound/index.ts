export { SoundEngine } from './sound-engine.ts';
export { hudEvents, countEvents, roomEvents, stateEvents } from './sound-events.ts';
export { moodOf, tuneOf } from './tunes.ts';
