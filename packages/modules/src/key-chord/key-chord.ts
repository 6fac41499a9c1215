import { defineProcessingModule } from '@ubii/pm-sandbox';

/** The keys that are held together, as a text such as "a + d". */
export const keyChord = defineProcessingModule({
  name: 'key-chord',
  description: 'Gives the keys that are held together as one text, such as "a + d".',
  tags: ['event', 'key', 'keyboard', 'text'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  inputs: { key: 'keyEvent' },
  outputs: { chord: 'string', count: 'int32' },
  mode: { triggerOnInput: {} },
  createState: (): { held: string[]; told: string | undefined } => ({ held: [], told: undefined }),
  onProcessing(_deltaTimeMs, inputs, state) {
    const event = inputs.key?.keyEvent;
    if (event === undefined) return undefined;
    // Longer names and more keys than a keyboard has are not kept.
    const key = event.key === ' ' ? 'Space' : event.key.slice(0, 32);
    const others = state.held.filter((held) => held !== key);
    // 1 is down, 0 is up.
    const isDown = Number(event.type) === 1;
    if (isDown && key !== '') {
      if (others.length === state.held.length && others.length < 16) state.held.push(key);
    } else state.held = others;
    const chord = state.held.join(' + ');
    if (chord === state.told) return undefined;
    state.told = chord;
    return { outputs: { chord: { string: chord }, count: { int32: state.held.length } } };
  },
});
