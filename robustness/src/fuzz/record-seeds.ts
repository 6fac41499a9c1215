import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { createClient } from '@ubii/client-web/node';
import { MasterProcess } from '@ubii/harness';
import { WebSocket } from 'ws';

import { SEEDS_FILE, type RecordedTraffic } from './seeds.ts';

const MAX_EACH = 80;

/** Runs programs of the client library against a master, and writes down what they send. */
export async function recordSeeds(program: string): Promise<string> {
  const traffic = {
    requests: new Set<string>(),
    frames: new Set<string>(),
    texts: new Set<string>(),
  };
  const plainFetch = globalThis.fetch;
  const send = Reflect.get(WebSocket.prototype, 'send') as (...args: unknown[]) => void;
  globalThis.fetch = (input, init) => {
    const body = init?.body;
    if (body instanceof Uint8Array) traffic.requests.add(base64(body));
    return plainFetch(input, init);
  };
  Reflect.set(WebSocket.prototype, 'send', function record(this: WebSocket, ...args: unknown[]) {
    const [data] = args;
    if (typeof data === 'string') traffic.texts.add(data);
    else if (data instanceof Uint8Array) traffic.frames.add(base64(data));
    send.apply(this, args);
  });
  const master = await MasterProcess.start({ program });
  try {
    await playScript(master.endpoints.url);
  } finally {
    globalThis.fetch = plainFetch;
    Reflect.set(WebSocket.prototype, 'send', send);
    await master.dispose();
  }
  const recorded: RecordedTraffic = {
    requests: [...traffic.requests].slice(0, MAX_EACH),
    frames: [...traffic.frames].slice(0, MAX_EACH),
    texts: [...traffic.texts].slice(0, MAX_EACH),
  };
  mkdirSync(dirname(SEEDS_FILE), { recursive: true });
  writeFileSync(SEEDS_FILE, `${JSON.stringify(recorded, undefined, 2)}\n`);
  return `${recorded.requests.length} requests, ${recorded.frames.length} frames and ${recorded.texts.length} texts in ${SEEDS_FILE}`;
}

/** One of everything a program does. */
async function playScript(url: string): Promise<void> {
  const phone = createClient({ url, name: 'phone', tags: ['touch'], publishIntervalMs: 0 });
  const screen = createClient({ url, name: 'screen', publishIntervalMs: 5 });
  await Promise.all([phone.connect(), screen.connect()]);
  const touches = screen.subscribe({ component: { tags: ['touch'] } }, { format: 'vector2' });
  const everything = screen.subscribe({ regex: '^/room/.*' });
  await Promise.all([touches.ready, everything.ready]);
  const device = await phone.registerDevice({
    name: 'smart device',
    components: [
      { name: 'touch', format: 'vector2', tags: ['touch'] },
      { name: 'orientation', format: 'quaternion' },
      { name: 'vibration', format: 'double', ioType: 'subscriber' },
    ],
  });
  device.component('touch').publish({ x: 0.25, y: 0.75 });
  const values = [
    ['double', 21.5],
    ['string', 'Größe'],
    ['bool', true],
    ['int32', -7],
    ['vector3', { x: 1, y: 2, z: 3 }],
    ['vector4', { x: 1, y: 2, z: 3, w: 4 }],
    ['quaternion', { x: 0, y: 0, z: 0, w: 1 }],
    ['color', { r: 1, g: 0, b: 0, a: 1 }],
    ['touchEvent', { type: 1, position: { x: 0.5, y: 0.5 } }],
    ['keyEvent', { type: 0, key: 'a' }],
    ['mouseEvent', { type: 0, button: 1 }],
    ['object2D', { id: 'o', pose: { position: { x: 1, y: 2 } } }],
    ['doubleList', { elements: [1, 2, 3] }],
    ['stringList', { elements: ['a', 'b'] }],
    ['image2D', { width: 2, height: 2, data: new Uint8Array(16) }],
  ] as const;
  for (const [format, value] of values) {
    try {
      screen.publish(`/room/${format}`, format, value as never);
    } catch {
      // A format of another name in this version: the others are enough.
    }
    await new Promise((resolve) => setTimeout(resolve, 8));
  }
  for (const [index, topic] of ['/room/a', '/room/b', '/room/c'].entries()) {
    screen.publish(topic, 'double', index);
  }
  await callServices(screen);
  await device.close();
  await everything.close();
  await Promise.all([phone.close(), screen.close()]);
}

async function callServices(client: ReturnType<typeof createClient>): Promise<void> {
  const call = client.call.bind(client) as unknown as (
    service: string,
    request?: object,
  ) => Promise<unknown>;
  const module = {
    name: 'double-it',
    processingMode: { triggerOnInput: { minDelayMs: 10 } },
    inputs: [{ internalName: 'in', messageFormat: 'double' }],
    outputs: [{ internalName: 'out', messageFormat: 'double' }],
    onProcessingStringified: '(deltaTime, inputs) => ({ outputs: { out: { double: 1 } } })',
  };
  const session = {
    name: 'seed session',
    processingModules: [module],
    ioMappings: [
      {
        processingModuleName: 'double-it',
        inputMappings: [
          { inputName: 'in', topicMux: { topicSelector: '/room/.*', dataType: 'double' } },
        ],
        outputMappings: [
          { outputName: 'out', topicDemux: { outputTopicFormat: '/out/%s', dataType: 'double' } },
        ],
      },
    ],
  };
  const calls: [string, object?][] = [
    ['serverConfiguration'],
    ['serviceList'],
    ['topicList'],
    ['clientGetList', { elements: [{ tags: ['touch'] }] }],
    ['deviceGetList', {}],
    ['componentGetList', { elements: [{ messageFormat: 'ubii.dataStructure.Vector2' }] }],
    ['topicStatistics', { cursor: 0 }],
    ['masterStatus', { sinceMs: 0 }],
    ['nodeList'],
    ['clientReport', {}],
    ['limitList'],
    ['settingList'],
    ['logTail', {}],
    ['joinCheck', { token: 'K7QF-2MXR' }],
    [
      'accessGrantCreate',
      { label: 'class', role: 3, readTopics: ['/room/*'], writeTopics: ['/room/a'] },
    ],
    ['accessGrantList'],
    ['processingModuleDatabaseSave', module],
    ['processingModuleDatabaseGetList'],
    ['moduleVersionList', { name: 'double-it' }],
    ['sessionDatabaseSave', session],
    ['sessionDatabaseGetList'],
    ['sessionRuntimeAdd', session],
    ['sessionRuntimeStart', session],
    ['sessionRuntimeGetList'],
    ['clientRename', { clientId: client.id, name: 'another name' }],
    ['clientThrottle', { clientId: client.id }],
  ];
  for (const [service, request] of calls) {
    try {
      await call(service, request);
    } catch {
      // No service of this name, or refused: the others are enough.
    }
  }
}

function base64(bytes: Uint8Array): string {
  return Buffer.from(bytes).toString('base64');
}
