import type { UbiiClient } from '@ubii/client-web';
import { SessionStatus, type Init, type ProcessingModule, type Session } from '@ubii/proto';
import { describe, expect, test } from 'vitest';
import { suiteName, useRoom, whyMissing } from '../harness/room.ts';

const room = useRoom();

/** Interval at which a value is published again that a node may have missed, milliseconds. */
const PUBLISH_AGAIN_MS = 200;

async function statusOf(ours: UbiiClient, id: string): Promise<SessionStatus> {
  return (await ours.call('sessionRuntimeGet', { id })).status;
}

async function start(ours: UbiiClient, session: Init<Session>): Promise<Session> {
  const started = await ours.call('sessionRuntimeStart', session);
  await expect
    .poll(() => statusOf(ours, started.id), { message: 'the session runs' })
    .toBe(SessionStatus.RUNNING);
  return started;
}

async function stop(ours: UbiiClient, { id }: Session): Promise<void> {
  await ours.call('sessionRuntimeStop', { id });
  await expect
    .poll(() => statusOf(ours, id), { message: 'the session has stopped' })
    .toBe(SessionStatus.STOPPED);
}

/** Everything that comes on the topics of a pattern. */
async function watch(ours: UbiiClient, glob: string): Promise<[topic: string, value: unknown][]> {
  const got: [string, unknown][] = [];
  const subscription = ours.subscribe({ glob });
  await subscription.ready;
  subscription.onRecord(({ topic, value }) => got.push([topic, value]));
  return got;
}

/** Publishes a value again and again until what it leads to is there. */
async function until(publish: () => void, isThere: () => void): Promise<void> {
  const again = setInterval(publish, PUBLISH_AGAIN_MS);
  try {
    publish();
    await expect.poll(() => isMet(isThere)).toBe(true);
  } finally {
    clearInterval(again);
  }
}

function isMet(expectation: () => void): boolean {
  try {
    expectation();
    return true;
  } catch {
    return false;
  }
}

/** A module and what it is mapped to. */
function sessionOf(
  module: Init<ProcessingModule>,
  mapping: Pick<
    Init<NonNullable<Session['ioMappings'][number]>>,
    'inputMappings' | 'outputMappings'
  >,
): Init<Session> {
  return {
    name: `session of ${module.name ?? ''}`,
    processingModules: [module],
    ioMappings: [{ processingModuleName: module.name ?? '', ...mapping }],
  };
}

const plain = {
  inputMappings: [{ inputName: 'value', topic: '/in' }],
  outputMappings: [{ outputName: 'scaled', topic: '/out' }],
};

const double = 'double';
const io = {
  inputs: [{ internalName: 'value', messageFormat: double }],
  outputs: [{ internalName: 'scaled', messageFormat: double }],
};

describe.skipIf(whyMissing('nodejs'))(`${suiteName('nodejs')} as a processing node`, () => {
  test('runs JavaScript of a session when its input changes, until the session stops [SE-12] [SE-13] [EC-11] [EC-12]', async () => {
    const guest = await room.joinsAsNode('nodejs');
    const ours = await room.oursJoins();
    const got = await watch(ours, '/out');
    const session = await start(
      ours,
      sessionOf(
        {
          name: 'js-scale',
          nodeId: guest.clientId,
          processingMode: { triggerOnInput: { minDelayMs: 0, allInputsNeedUpdate: false } },
          ...io,
          onCreatedStringified: '(state) => { state.factor = 10; }',
          onProcessingStringified:
            '(deltaTime, inputs, state) => { if (inputs.value) return { outputs: { scaled: { double: inputs.value.double * state.factor } }, state }; return { outputs: {}, state }; }',
        },
        plain,
      ),
    );
    expect(session.processingModules[0]?.nodeId).toBe(guest.clientId);
    let value = 0;
    await until(
      () => ours.publish('/in', 'double', ++value),
      () => expect(got.at(-1)?.[1]).toBeGreaterThanOrEqual(10),
    );
    expect(Number(got.at(-1)?.[1]) % 10).toBe(0);

    await stop(ours, session);
    const count = got.length;
    ours.publish('/in', 'double', 1_000);
    ours.publish('/out', 'string', 'the last');
    await expect.poll(() => got.at(-1)).toEqual(['/out', 'the last']);
    expect(got).toHaveLength(count + 1);

    await start(ours, { id: session.id });
    await until(
      () => ours.publish('/in', 'double', 7),
      () => expect(got.at(-1)).toEqual(['/out', 70]),
    );
  });

  test('runs one with a frequency, without inputs', async () => {
    const guest = await room.joinsAsNode('nodejs');
    const ours = await room.oursJoins();
    const got = await watch(ours, '/out');
    await start(
      ours,
      sessionOf(
        {
          name: 'js-count',
          nodeId: guest.clientId,
          processingMode: { frequency: { hertz: 30 } },
          outputs: io.outputs,
          onCreatedStringified: 'function (state) { state.count = 0; }',
          onProcessingStringified:
            '(deltaTime, inputs, state) => { state.count += 1; return { outputs: { scaled: { double: state.count } }, state }; }',
        },
        { inputMappings: [], outputMappings: plain.outputMappings },
      ),
    );
    await expect.poll(() => got.length).toBeGreaterThanOrEqual(5);
    const counts = got.slice(0, 5).map(([, count]) => Number(count));
    expect([...counts].sort((a, b) => a - b)).toEqual(counts);
  });

  test('runs one over a muxer and a demuxer [SE-2] [EC-11]', async () => {
    const guest = await room.joinsAsNode('nodejs');
    const ours = await room.oursJoins();
    const got = await watch(ours, '/players/*/score');
    const players = [
      '11111111-2222-4333-8444-555555555555',
      'aaaaaaaa-bbbb-4ccc-8ddd-eeeeeeeeeeee',
    ];
    await start(
      ours,
      sessionOf(
        {
          name: 'js-scores',
          nodeId: guest.clientId,
          processingMode: { triggerOnInput: { minDelayMs: 0, allInputsNeedUpdate: false } },
          inputs: [{ internalName: 'moves', messageFormat: double, isRecordList: true }],
          outputs: [{ internalName: 'scores', messageFormat: double, isRecordList: true }],
          onProcessingStringified:
            '(deltaTime, inputs, state) => { const moves = (inputs.moves && inputs.moves.elements) || []; return { outputs: { scores: { elements: moves.map((move) => ({ double: move.double + 1, outputTopicParams: [move.identity] })) } }, state }; }',
        },
        {
          inputMappings: [
            {
              inputName: 'moves',
              topicMux: {
                dataType: 'double',
                topicSelector: '^/players/[^/]+/move$',
                identityMatchPattern:
                  '[0-9a-z]{8}-[0-9a-z]{4}-[0-9a-z]{4}-[0-9a-z]{4}-[0-9a-z]{12}',
              },
            },
          ],
          outputMappings: [
            {
              outputName: 'scores',
              topicDemux: { dataType: 'double', outputTopicFormat: '/players/{{#0}}/score' },
            },
          ],
        },
      ),
    );
    await until(
      () => players.forEach((id, i) => ours.publish(`/players/${id}/move`, 'double', 5 + i)),
      () => {
        expect(got).toContainEqual([`/players/${players[0]}/score`, 6]);
        expect(got).toContainEqual([`/players/${players[1]}/score`, 7]);
      },
    );
  });
});

describe.skipIf(whyMissing('python'))(`${suiteName('python')} as a processing node`, () => {
  test.each([
    ['when its input changes', { triggerOnInput: { allInputsNeedUpdate: true } }],
    ['with a frequency', { frequency: { hertz: 20 } }],
  ] as const)(
    'runs a routine of its own %s, until the session stops [EC-10] [EC-11]',
    async (_title, mode) => {
      const guest = await room.joinsAsNode('python');
      const ours = await room.oursJoins();
      const got = await watch(ours, '/out');
      const session = await start(
        ours,
        sessionOf({ name: 'py-scale', nodeId: guest.clientId, processingMode: mode, ...io }, plain),
      );
      let value = 0;
      await until(
        () => ours.publish('/in', 'double', ++value),
        () => expect(got.at(-1)?.[1]).toBeGreaterThanOrEqual(3),
      );
      expect(Number(got.at(-1)?.[1]) % 3).toBe(0);
      await stop(ours, session);
    },
  );

  test('is chosen for a module that only it has, by its name [SE-30]', async () => {
    const guest = await room.joinsAsNode('python');
    const ours = await room.oursJoins();
    const got = await watch(ours, '/out');
    const session = await start(ours, sessionOf({ name: 'py-scale' }, plain));
    expect(session.processingModules).toMatchObject([
      { name: 'py-scale', nodeId: guest.clientId, inputs: io.inputs },
    ]);
    await until(
      () => ours.publish('/in', 'double', 2),
      () => expect(got.at(-1)).toEqual(['/out', 6]),
    );
  });
});
