import { LazyPatterns } from '@ubii/patterns';
import { Re2Patterns } from '@ubii/patterns/re2';
import type { Init, Session } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { createNodeWorld, rest } from '../testing/node-world.ts';
import type { ProcessingNodeOptions } from './processing-node.ts';

const SLOW = '(a+)+$';
const TOPIC = `/${'a'.repeat(1000)}!`;

/** A session with a module that counts the elements of a muxer. */
function countingSession(nodeId: string, mux: object): Init<Session> {
  return {
    id: 's1',
    name: 'lesson',
    processingModules: [
      {
        id: 'm1',
        nodeId,
        name: 'count',
        processingMode: { triggerOnInput: {} },
        inputs: [{ internalName: 'in', messageFormat: 'double', isRecordList: true }],
        outputs: [{ internalName: 'out', messageFormat: 'string' }],
        onProcessingStringified:
          '(dt, inputs) => ({ outputs: { out: { string: inputs.in.elements.map((e) => e.identity ?? "-").join() } } })',
      },
    ],
    ioMappings: [
      {
        processingModuleId: 'm1',
        processingModuleName: 'count',
        inputMappings: [{ inputName: 'in', topicMux: mux }],
        outputMappings: [{ outputName: 'out', topic: '/out' }],
      },
    ],
  };
}

async function run(mux: object, options: Partial<ProcessingNodeOptions> = {}) {
  let loads = 0;
  const patterns = new LazyPatterns(async () => {
    loads += 1;
    return Promise.resolve(new Re2Patterns());
  });
  const world = await createNodeWorld({ patterns, ...options });
  world.sessions.start(countingSession(world.client.id, mux));
  await rest();
  world.master.publish({ topic: TOPIC, format: 'double', value: 1 });
  world.master.publish({ topic: '/x/aaa', format: 'double', value: 2 });
  await rest();
  const out = world.master.published.filter(({ topic }) => topic === '/out').at(-1)?.value;
  return { ...world, out, loads };
}

describe.each(['node', 'browser'] as const)('the muxers of a %s node', (kind) => {
  it('[PM-70] continue with a selector that stalls others', async () => {
    const { out, loads } = await run({ topicSelector: SLOW, identitySource: 3 }, { kind });
    expect(out).toBe('/x/aaa');
    expect(loads).toBe(1);
  });

  it('[PM-70] continue with an identity that stalls others', async () => {
    const mux = { topicGlob: '/**', identityMatchPattern: SLOW };
    const { out } = await run(mux, { kind });
    expect(out).toBe('-,aaa');
  });

  it('[TD-64] load no engine for globs', async () => {
    const { out, loads } = await run({ topicGlob: '/*/aaa' }, { kind });
    expect(out).toBe('/x/aaa');
    expect(loads).toBe(0);
  });

  it('[TD-64] fail with the reason when the engine cannot be had', async () => {
    const patterns = new LazyPatterns(() => Promise.reject(new Error('no network')));
    const { node } = await run({ topicSelector: 'a' }, { kind, patterns });
    expect(node.instances).toMatchObject([{ fault: { message: 'no network' } }]);
  });
});
