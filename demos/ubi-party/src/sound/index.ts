export { SoundEngine } from './audio/sound-engine.ts';
export { hudEvents } from './events/hud-events.ts';
export { countEvents, roomEvents } from './events/room-events.ts';
export { stateEvents } from './events/state-events.ts';
export { moodOf } from './music/mood.ts';
export { tuneOf } from './music/tunes.ts';
