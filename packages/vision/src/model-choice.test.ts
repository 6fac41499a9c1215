import { expect, it } from 'vitest';
import type { PreviousFault } from './backend-replacement.ts';
import { ModelChoice } from './model-choice.ts';
import type { Tensorflow, WantedBackend } from './tensorflow/create-tensorflow.ts';

const TOO_LONG: PreviousFault = {
  kind: 'timeout',
  message: 'onProcessing waited longer than 10000 ms for a promise, the limit of one call.',
};
const BECAUSE = `because the module was restarted: ${TOO_LONG.message}`;

/** Every backend works; `started` are those that were asked for. */
async function choiceAfter(previousFault: PreviousFault | undefined, isProvisional = false) {
  const started: WantedBackend[] = [];
  const createTensorflow = (_files: object, wanted: WantedBackend): Promise<Tensorflow> => {
    started.push(wanted);
    const backend = wanted === 'soonest' ? 'wasm' : wanted === 'auto' ? 'webgl' : wanted;
    return Promise.resolve({
      backend,
      instance: {},
      reason: '',
      trials: [],
      isProvisional: isProvisional && wanted === 'soonest',
      run: (async (task) => task()) as Tensorflow['run'],
      loadModel: () => Promise.reject(new Error('There is none.')),
    });
  };
  const model = { dispose: () => undefined };
  const choice = await ModelChoice.create({
    tensorflow: {},
    models: {
      only: { title: 'The model', load: () => ({}), create: () => Promise.resolve(model) },
    },
    createTensorflow,
    previousFault,
  });
  const choose = async (backend: string): Promise<string> => {
    choice.choose('only', backend);
    await choice.use(() => Promise.resolve());
    await choice.settled();
    return choice.backend;
  };
  return { choice, choose, started };
}

it('computes on wasm, and says why, after webgl took too long for a call [PM-97]', async () => {
  const { choice, choose, started } = await choiceAfter(TOO_LONG);
  expect(await choose('webgl')).toBe('wasm');
  expect(await choose('webgl')).toBe('wasm');
  expect(started).not.toContain('webgl');
  expect(choice.backendFault).toBe(`webgl is not tried again, ${BECAUSE} wasm replaces it.`);
  expect(choice.problem).toContain(`${BECAUSE} wasm is used instead.`);
});

it('tries webgl again when it is chosen again [PM-97]', async () => {
  const { choice, choose } = await choiceAfter(TOO_LONG);
  const backends = [await choose('webgl'), await choose('wasm'), await choose('webgl')];
  expect(backends).toEqual(['wasm', 'wasm', 'webgl']);
  expect([choice.backendFault, choice.problem]).toEqual(['', '']);
});

it('does not move to the graphics card by itself after a call took too long [PM-97]', async () => {
  const { choice, choose, started } = await choiceAfter(TOO_LONG, true);
  expect(await choose('auto')).toBe('wasm');
  expect(started).toEqual(['soonest']);
  expect(choice.backendFault).toContain(`The graphics card is not tried again, ${BECAUSE}`);
});

it.each([
  ['is new', undefined],
  ['lost its worker to another module', { kind: 'crashed', message: '', isOfOther: true }],
  ['threw', { kind: 'threw', message: '' }],
])('uses what is chosen when the instance %s', async (_, fault) => {
  const { choice, choose } = await choiceAfter(fault);
  expect([await choose('webgl'), choice.backendFault]).toEqual(['webgl', '']);
  expect(await (await choiceAfter(fault, true)).choose('auto')).toBe('webgl');
});
