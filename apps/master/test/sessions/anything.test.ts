import fc from 'fast-check';
import type { Init, ProcessingModule, ServiceReply, Session } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { doubler, SessionWorld, TOPICS } from './session-world.ts';
import { TestNode } from './test-node.ts';

const topic = fc.constantFrom('/a', '/b', '/info/x', '', 'no slash', '/x\n', '__proto__');
const name = fc.constantFrom('doubler', 'offered', 'unknown', '', '__proto__', 'constructor');
const text = fc.constantFrom(
  '',
  '(',
  '() => ({})',
  'function () { throw 1; }',
  doubler.onProcessingStringified,
);
const nodeId = fc.constantFrom('', '', 'master', 'node', 'original', 'stranger');
const ioName = fc.constantFrom('in', 'out', '', '__proto__');
const format = fc.constantFrom('double', 'vector2', 'nonsense', '');
const id = fc.constantFrom('', '11111111-1111-4111-8111-111111111111', 'x');

const io = fc.record({ internalName: ioName, messageFormat: format, isRecordList: fc.boolean() });
const mode = fc.constantFrom(
  undefined,
  { frequency: { hertz: -1 } },
  { triggerOnInput: {} },
  { lockstep: {} },
  { free: {} },
);
const module = fc.oneof(
  fc.constant(doubler),
  fc.record({
    id,
    name,
    nodeId,
    onProcessingStringified: text,
    onCreatedStringified: text,
    inputs: fc.array(io, { maxLength: 2 }),
    outputs: fc.array(io, { maxLength: 2 }),
    processingMode: mode,
    language: fc.constantFrom(0, 1, 2, 4),
  }),
);
const mux = fc.record({
  topicSelector: fc.constantFrom('', '/a', '(', '.*'),
  topicGlob: fc.constantFrom('', '/*'),
  identityMatchPattern: fc.constantFrom('', '['),
  dataType: format,
});
const demux = fc.record({ outputTopicFormat: fc.constantFrom('', '/x/{{#0}}', '%s', '/ubii/%s') });
const mapping = fc.record({
  processingModuleId: id,
  processingModuleName: name,
  inputMappings: fc.array(
    fc.oneof(
      fc.record({ inputName: ioName, topic }),
      fc.record({ inputName: ioName, topicMux: mux }),
      fc.record({ inputName: ioName, constantJson: fc.constantFrom('{"double":1}', '{', '7') }),
    ),
    { maxLength: 2 },
  ),
  outputMappings: fc.array(
    fc.oneof(
      fc.record({ outputName: ioName, topic }),
      fc.record({ outputName: ioName, topicDemux: demux }),
    ),
    { maxLength: 2 },
  ),
});
const session = fc.record({
  id,
  name,
  processingModules: fc.array(module, { maxLength: 3 }),
  ioMappings: fc.array(mapping, { maxLength: 3 }),
  extension: fc.record({
    startWithMaster: fc.boolean(),
    lockstepHertz: fc.constantFrom(0, -5, 1e9, Number.NaN),
    revision: fc.constantFrom(0, 1, 7),
  }),
});

const step = fc.oneof(
  fc.record({ do: fc.constantFrom('add', 'start', 'save'), session }),
  fc.record({
    do: fc.constantFrom('start', 'stop', 'pause', 'resume', 'remove', 'update', 'save'),
    index: fc.nat(3),
    session,
  }),
  fc.record({ do: fc.constantFrom('ran', 'ended'), index: fc.nat(3) }),
  fc.record({ do: fc.constantFrom('node drops', 'node comes', 'record', 'time') }),
);

describe('whatever is asked of sessions', () => {
  it('gets an answer that is no fault of ours, and leaves nothing behind', async () => {
    await fc.assert(
      fc.asyncProperty(fc.array(step, { minLength: 1, maxLength: 25 }), async (steps) => {
        const world = await SessionWorld.create();
        const node = await TestNode.ours(world.master, 'node', { processingModules: [doubler] });
        const original = await TestNode.original(world.master, 'original', {
          processingModules: [{ name: 'offered' }],
        });
        const timers = world.master.clock.timerCount;
        const withIds = (given: Init<Session>): Init<Session> => ({
          ...given,
          processingModules: (given.processingModules ?? []).map((one) => ({
            ...one,
            nodeId:
              { node: node.id, original: original.id }[one?.nodeId ?? ''] ?? one?.nodeId ?? '',
          })),
        });
        const known = async (): Promise<Session[]> => {
          const { sessionList } = await world.master.call({ topic: TOPICS.list });
          return sessionList!.elements;
        };
        const check = ({ error }: ServiceReply): void => {
          if (error?.code === 'internal') throw new Error(error.message);
        };
        for (const one of steps) {
          const sessions = await known();
          const at = 'index' in one ? sessions[one.index] : undefined;
          if (one.do === 'time') await world.master.pass(700);
          else if (one.do === 'record') world.ada.publish('/a', 'double', 1);
          else if (one.do === 'node drops') node.client.drop();
          else if (one.do === 'node comes') node.client.open();
          else if (one.do === 'ran' || one.do === 'ended') {
            check(await (one.do === 'ran' ? node.ran : node.ended).call(node, modulesOf(at)));
          } else if ('session' in one) {
            const wanted = withIds(one.session);
            const request = 'index' in one ? { ...wanted, id: at?.id ?? wanted.id ?? '' } : wanted;
            check(
              await world.master.call({
                topic: TOPICS[one.do as keyof typeof TOPICS],
                session: request,
              }),
            );
          }
          await world.master.pass();
        }
        for (const { id: sessionId } of await known()) {
          check(await world.master.call({ topic: TOPICS.remove, session: { id: sessionId } }));
        }
        await world.master.pass(5_000);
        expect(await known()).toEqual([]);
        expect(world.master.log.lines.filter(({ level }) => level === 'error')).toEqual([]);
        expect(world.master.clock.timerCount).toBeLessThanOrEqual(timers);
        const metric = world.master.master
          .metrics()
          .find((one) => one.name === 'ubii_module_instances');
        expect(metric?.values[0]?.value).toBe(0);
      }),
      { numRuns: 60 },
    );
  }, 120_000);
});

function modulesOf(session: Session | undefined): ProcessingModule[] {
  return session?.processingModules ?? [];
}
