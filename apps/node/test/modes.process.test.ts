import { createClient, createMemoryIdentity } from '@ubii/client-web/node';
import type { UbiiClient } from '@ubii/client-web/node';
import { MuxIdentity, ProcessingModuleLanguage } from '@ubii/proto';
import type { Init, ProcessingMode, ProcessingModule, Session, Vector2 } from '@ubii/proto';
import { describe, expect, it, onTestFinished, vi } from 'vitest';
import { startMaster, startNode } from './programs.ts';

// Each test starts three programs, which takes long on a busy machine.
vi.setConfig({ testTimeout: 90_000 });
const POLL = { timeout: 45_000 };

/** Starts a master and two nodes, each as a separate process. */
async function startRoom() {
  const master = await startMaster();
  const nodeIds: string[] = [];
  for (const name of ['west', 'east']) {
    const node = startNode(['--master', master.url, '--name', name, '--print-endpoints', 'json']);
    nodeIds.push((await node.ready<{ id: string }>()).id);
  }
  const join = async (name: string): Promise<UbiiClient> => {
    const client = createClient({ url: master.url, name, identity: createMemoryIdentity() });
    onTestFinished(() => client.close());
    await client.connect();
    return client;
  };
  const [west, east] = nodeIds as [string, string];
  return { join, west, east };
}

function moduleOf(
  name: string,
  nodeId: string,
  processingMode: Init<ProcessingMode>,
  onProcessingStringified: string,
): Init<ProcessingModule> & { readonly name: string } {
  return {
    name,
    nodeId,
    processingMode,
    onProcessingStringified,
    language: ProcessingModuleLanguage.JS,
    inputs: [{ internalName: 'in', messageFormat: 'double' }],
    outputs: [{ internalName: 'out', messageFormat: 'vector2' }],
  };
}

/** Subscribes to a topic. The returned list grows with each record. */
async function listen(client: UbiiClient, topic: string): Promise<Vector2[]> {
  const values: Vector2[] = [];
  const subscription = client.subscribe<'vector2'>(topic, { format: 'vector2' });
  await subscription.onRecord(({ value }) => values.push(value)).ready;
  return values;
}

const COUNT = `(deltaTime, inputs, state) => {
  state.runs = (state.runs ?? 0) + 1;
  return { outputs: { out: { vector2: { x: inputs.in?.double ?? 0, y: state.runs } } } };
}`;
const TELL_DELTA = `(deltaTime, inputs) =>
  ({ outputs: { out: { vector2: { x: inputs.in?.double ?? 0, y: deltaTime } } } })`;

describe('one session over a master and two nodes', () => {
  it('mixes all modes [PM-21, PM-23, PM-27, PM-28, SE-40, SE-41]', async () => {
    const { join, west, east } = await startRoom();
    const client = await join('guest');
    const places = { master: 'master', west, east };
    const locked = Object.entries(places).map(([place, nodeId]) =>
      moduleOf(`locked-${place}`, nodeId, { lockstep: {} }, TELL_DELTA),
    );
    const modules = [
      moduleOf('often', 'master', { frequency: { hertz: 50 } }, COUNT),
      moduleOf('when-told', west, { triggerOnInput: {} }, COUNT),
      moduleOf('freely', east, { free: {} }, COUNT),
      ...locked,
    ];
    const heard = new Map<string, Vector2[]>();
    for (const { name } of modules) heard.set(name, await listen(client, `/out/${name}`));
    const session = await client.call('sessionRuntimeStart', {
      name: 'all modes',
      processingModules: modules,
      ioMappings: modules.map(({ name }) => ({
        processingModuleName: name,
        inputMappings: [{ inputName: 'in', topic: '/in' }],
        outputMappings: [{ outputName: 'out', topic: `/out/${name}` }],
      })),
    });

    // In the modes frequency and free, modules run without input; in trigger mode they do not.
    await expect.poll(() => heard.get('often')!.length, POLL).toBeGreaterThan(10);
    await expect.poll(() => heard.get('freely')!.length, POLL).toBeGreaterThan(10);
    expect(heard.get('when-told')).toEqual([]);

    for (const [run, value] of [5, 6, 7].entries()) {
      client.publish('/in', 'double', value, { immediate: true });
      await expect
        .poll(() => heard.get('when-told')!.at(-1), POLL)
        .toEqual({ x: value, y: run + 1 });
    }

    // All modules of one pass have the same delta time and the same input.
    const inputsByPass = (name: string): Map<number, number> =>
      new Map(heard.get(name)!.map(({ x, y }) => [y, x]));
    await expect
      .poll(() => {
        const [first, ...others] = locked.map(({ name }) => inputsByPass(name));
        const common = [...first!].filter(([pass]) => others.every((one) => one.has(pass)));
        for (const [pass, input] of common) {
          for (const other of others) expect(other.get(pass)).toBe(input);
        }
        return common.filter(([, input]) => input === 7).length;
      }, POLL)
      .toBeGreaterThan(10);
    await client.call('sessionRuntimeStop', { id: session.id });
  });

  it.each<[string, Init<ProcessingMode>]>([
    ['the master', { frequency: { hertz: 30 } }],
    ['a node', { triggerOnInput: {} }],
  ])(
    'gathers and answers clients that join and leave, on %s [PM-40 to PM-46]',
    async (place, mode) => {
      const { join, west } = await startRoom();
      const host = await join('host');
      const session: Init<Session> = {
        name: 'a crowd',
        processingModules: [
          {
            ...moduleOf('crowd', place === 'a node' ? west : 'master', mode, ''),
            inputs: [{ internalName: 'touches', messageFormat: 'vector2', isRecordList: true }],
            outputs: [{ internalName: 'answers', messageFormat: 'vector2', isRecordList: true }],
            onProcessingStringified: `(deltaTime, { touches }) => ({
            outputs: {
              answers: {
                elements: touches.elements.map(({ vector2, identity }) => ({
                  vector2: { x: vector2.x, y: touches.elements.length },
                  outputTopicParams: [identity],
                })),
              },
            },
          })`,
          },
        ],
        ioMappings: [
          {
            processingModuleName: 'crowd',
            inputMappings: [
              {
                inputName: 'touches',
                topicMux: {
                  topicGlob: '/phones/*/touch',
                  identitySource: MuxIdentity.MUX_IDENTITY_PATTERN,
                  identityMatchPattern: '^/phones/([^/]+)/touch$',
                  identityGroup: 1,
                },
              },
            ],
            outputMappings: [
              {
                outputName: 'answers',
                topicDemux: { outputTopicFormat: '/phones/{{#0}}/answer' },
              },
            ],
          },
        ],
      };
      const comeIn = async (name: string, x: number) => {
        const phone = await join(name);
        const answers = await listen(phone, `/phones/${name}/answer`);
        const touch = (): void => phone.publish(`/phones/${name}/touch`, 'vector2', { x, y: 0 });
        touch();
        return { phone, answers, touch, x };
      };
      const ann = await comeIn('ann', 0.25);
      await host.call('sessionRuntimeStart', session);
      const hears = async (who: typeof ann, others: number): Promise<void> => {
        await expect
          .poll(() => {
            who.touch();
            return who.answers.at(-1);
          }, POLL)
          .toEqual({ x: who.x, y: others });
      };
      await hears(ann, 1); // Published before the session started.
      const bob = await comeIn('bob', 0.5);
      await hears(bob, 2);
      await hears(ann, 2);
      await bob.phone.close();
      await hears(ann, 1);
      const cleo = await comeIn('cleo', 0.75);
      await hears(cleo, 2);
      await hears(ann, 2);
    },
  );
});
