import { defineProcessingModule } from '@ubii/pm-sandbox';

/** Joins the keys that are held down into a text such as "a + d". */
export const keyChord = defineProcessingModule({
  name: 'key-chord',
  description: 'Joins the held keys into a text, such as a + d.',
  tags: ['event', 'key', 'keyboard', 'text'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  inputs: {
    key: { format: 'keyEvent', description: 'Key events, pressed and released.' },
  },
  outputs: {
    chord: {
      format: 'string',
      description: 'The held keys in the order in which they were pressed, such as a + d.',
    },
    count: { format: 'int32', description: 'Number of held keys, 0 to 16.' },
  },
  mode: { triggerOnInput: {} },
  createState: (): { held: string[]; told: string | undefined } => ({ held: [], told: undefined }),
  onProcessing(_deltaTimeMs, inputs, state) {
    const event = inputs.key?.keyEvent;
    if (event === undefined) return undefined;
    // Bound the names and the number of keys.
    const key = event.key === ' ' ? 'Space' : event.key.slice(0, 32);
    const others = state.held.filter((held) => held !== key);
    // 1: key down, 0: key up.
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
