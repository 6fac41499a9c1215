import { createClient } from '@ubii/client-web/node';
import type { Init, Session } from '@ubii/proto';

import { pause } from '../pause.ts';
import type { MasterProcess } from './master-process.ts';

const PATIENCE_MS = 5_000;

/** Puts out `perRun` elements, 20 times a second, on topics that no run before had. */
export function demuxing(name: string, perRun: number): Init<Session> {
  return {
    name,
    processingModules: [
      {
        name,
        outputs: [{ internalName: 'out', messageFormat: 'double' }],
        processingMode: { frequency: { hertz: 20 } },
        onCreatedStringified: '(state) => { state.count = 0; }',
        onProcessingStringified: `(deltaTime, inputs, state) => ({ outputs: { out: { elements:
          Array.from({ length: ${perRun} }, () => ({ double: 1, outputTopicParams: [String(state.count++)] })) } } })`,
      },
    ],
    ioMappings: [
      {
        processingModuleName: name,
        outputMappings: [
          { outputName: 'out', topicDemux: { outputTopicFormat: `/${name}/{{#0}}` } },
        ],
      },
    ],
  };
}

/** Publishes a number on a topic 20 times a second. */
export function ticking(name: string, topic: string): Init<Session> {
  return {
    name,
    processingModules: [
      {
        name,
        outputs: [{ internalName: 'out', messageFormat: 'double' }],
        processingMode: { frequency: { hertz: 20 } },
        onProcessingStringified: '() => ({ outputs: { out: { double: 1 } } })',
      },
    ],
    ioMappings: [{ processingModuleName: name, outputMappings: [{ outputName: 'out', topic }] }],
  };
}

/** Whether records come on topics of a pattern, new ones rather than the value that was kept. */
export async function receives(master: MasterProcess, regex: string): Promise<boolean> {
  const client = createClient({ url: master.endpoints.url, name: 'listener' });
  await client.connect();
  try {
    let count = 0;
    const subscription = client.subscribe({ regex });
    subscription.onRecord(() => count++);
    await subscription.ready;
    await pause(500);
    const kept = count;
    const endMs = performance.now() + PATIENCE_MS;
    while (count === kept && performance.now() < endMs) await pause(100);
    return count > kept;
  } finally {
    await client.close();
  }
}

/** Topics with a value, as the list of topics says. */
export async function topicsOf(master: MasterProcess): Promise<number> {
  const { stringList } = await master.call({ topic: '/services/topic_list' });
  return stringList!.elements.length;
}
