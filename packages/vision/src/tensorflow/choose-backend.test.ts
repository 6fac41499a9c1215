import { describe, expect, it } from 'vitest';
import { type BackendCandidate, chooseBackend } from './choose-backend.ts';

/** A clock that candidates move, and candidates that take a told time. */
function world() {
  let nowMs = 0;
  return {
    now: () => nowMs,
    candidate: (
      name: BackendCandidate['name'],
      ms: number,
      rest: Partial<BackendCandidate> & { error?: number } = {},
    ): BackendCandidate => ({
      name,
      start: () => Promise.resolve(),
      probe: () => {
        nowMs += ms;
        return Promise.resolve(rest.error ?? 0);
      },
      ...rest,
    }),
  };
}

describe('chooseBackend', () => {
  it('takes the fastest backend, with times of all', async () => {
    const { now, candidate } = world();
    const choice = await chooseBackend([candidate('webgl', 30), candidate('wasm', 10)], { now });
    expect(choice).toEqual({
      backend: 'wasm',
      reason: 'wasm is the fastest backend with right results.',
      isProvisional: false,
      trials: [
        { name: 'webgl', outcome: 'slower', reason: 'wasm is faster.', startMs: 30, probeMs: 30 },
        {
          name: 'wasm',
          outcome: 'chosen',
          reason: 'Its results are right.',
          startMs: 10,
          probeMs: 10,
        },
      ],
    });
  });

  it('refuses a fast backend whose numbers are wrong', async () => {
    const { now, candidate } = world();
    const { backend, trials } = await chooseBackend(
      [candidate('webgpu', 1, { error: 0.25 }), candidate('wasm', 10)],
      { now },
    );
    expect(backend).toBe('wasm');
    expect(trials[0]).toMatchObject({
      outcome: 'wrong',
      reason: 'Its numbers differ from the reference by 25.0 %.',
    });
  });

  it('refuses a backend that gives no numbers', async () => {
    const { now, candidate } = world();
    const { trials } = await chooseBackend(
      [candidate('webgpu', 1, { error: Infinity }), candidate('wasm', 10)],
      { now },
    );
    expect(trials[0]!.reason).toBe('Its results are not numbers.');
  });

  it('takes the wanted backend although another would be faster', async () => {
    const { now, candidate } = world();
    const candidates = [candidate('wasm', 10), candidate('cpu', 90, { isLastResort: true })];
    const choice = await chooseBackend(candidates, { now, wanted: 'cpu' });
    expect(choice.backend).toBe('cpu');
    expect(choice.reason).toBe('cpu was asked for and works.');
    expect(choice.trials[1]).toEqual({ name: 'wasm', outcome: 'not tried', reason: 'cpu works.' });
  });

  it('falls back with the reason when the wanted backend fails', async () => {
    const { now, candidate } = world();
    const start = () => Promise.reject(new Error('The graphics card was lost.'));
    const candidates = [candidate('webgl', 1, { start }), candidate('wasm', 10)];
    const { backend, reason } = await chooseBackend(candidates, { now, wanted: 'webgl' });
    expect(backend).toBe('wasm');
    expect(reason).toBe('wasm instead of webgl: The graphics card was lost.');
  });

  it('starts with the backend that starts soonest, and leaves the others for later', async () => {
    const { now, candidate } = world();
    const candidates = [candidate('webgl', 3), candidate('wasm', 10)];
    const choice = await chooseBackend(candidates, { now, wanted: 'wasm', isProvisional: true });
    expect(choice.reason).toBe(
      'wasm starts soonest; the others are measured after the first result.',
    );
    expect(choice.isProvisional).toBe(true);
    expect(choice.trials[1]).toEqual({
      name: 'webgl',
      outcome: 'not tried',
      reason: 'wasm works.',
    });
  });

  it('leaves nothing for later when the others are absent or a last resort', async () => {
    const { now, candidate } = world();
    const absence = 'This browser has no WebGL 2 in workers.';
    const candidates = [
      candidate('webgpu', 1, { absence }),
      candidate('webgl', 90, { isLastResort: true }),
      candidate('wasm', 10),
    ];
    const choice = await chooseBackend(candidates, { now, wanted: 'wasm', isProvisional: true });
    expect(choice.isProvisional).toBe(false);
    expect(choice.reason).toBe('wasm is the fastest backend with right results.');
    expect(choice.trials[1]).toEqual({ name: 'webgpu', outcome: 'absent', reason: absence });
  });

  it('tries the last resort only when nothing else works', async () => {
    const { now, candidate } = world();
    const cpu = candidate('cpu', 90, { isLastResort: true });
    const wasm = candidate('wasm', 10);
    const missing = { ...wasm, absence: 'The file was not passed to createTensorflow.' };
    expect((await chooseBackend([cpu, wasm], { now })).trials[1]!.outcome).toBe('not tried');
    expect((await chooseBackend([cpu, missing], { now })).backend).toBe('cpu');
  });

  it('measures a slow backend by less runs', async () => {
    const { now, candidate } = world();
    const { trials } = await chooseBackend([candidate('webgl', 250)], { now });
    expect(trials[0]!.probeMs).toBe(250);
    // The first run, and two of which the second began before the limit.
    expect(now()).toBe(3 * 250);
  });

  it('throws with all reasons when none works', async () => {
    const { now, candidate } = world();
    const probe = () => Promise.reject(new Error('out of memory'));
    await expect(chooseBackend([candidate('wasm', 1, { probe })], { now })).rejects.toThrow(
      'No backend of TensorFlow.js works here. wasm: out of memory.',
    );
  });
});
