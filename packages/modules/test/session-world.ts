import { Re2Patterns } from '@ubii/patterns/re2';
import { createModuleRuntime, type ModuleRuntime } from '@ubii/pm-sandbox';
import { createInlineSandboxes, FakeTopics } from '@ubii/pm-sandbox/testing';
import { decode, encode, type Init, type ModuleEvent, type Session } from '@ubii/proto';
import { FakeClock } from '@ubii/timing/testing';
import { moduleLibrary } from '../src/index.ts';

/** A session that runs on one node, with a clock and topics of the test. */
export interface SessionWorld {
  readonly clock: FakeClock;
  readonly topics: FakeTopics;
  readonly runtime: ModuleRuntime;
  /** Errors and log lines of the modules. */
  readonly events: readonly ModuleEvent[];
  /** Ids of the instances, by the name of the module; of several with one name, the first. */
  readonly ids: ReadonlyMap<string, string>;
  /** Everything that was published on a topic, oldest first. */
  values(topic: string): unknown[];
}

const SESSION = 'ubii.sessions.Session';

/** Starts a session as a node does: modules by their names, from the library. */
export async function startSession(
  init: Init<Session>,
  libraries: { readonly [name: string]: unknown } = {},
): Promise<SessionWorld> {
  const session = decode(SESSION, encode(SESSION, init));
  const clock = new FakeClock();
  const topics = new FakeTopics();
  const events: ModuleEvent[] = [];
  const runtime = createModuleRuntime({
    nodeId: 'node-1',
    clock,
    topics,
    patterns: new Re2Patterns(),
    sandboxes: createInlineSandboxes({ libraries }),
    libraries: Object.keys(libraries),
    onEvent: (event) => events.push(event),
    onStatus: () => undefined,
  });
  const library = moduleLibrary();
  const ids = new Map<string, string>();
  const all: string[] = [];
  const free = [...session.ioMappings];
  for (const [index, { name, processingMode }] of session.processingModules.entries()) {
    // Mappings go to the modules of their name in order. [SE-2]
    const at = free.findIndex((mapping) => mapping.processingModuleName === name);
    const [mapping] = free.splice(at, 1);
    const module = library.find((candidate) => candidate.name === name)!;
    const id = `module-${index}`;
    if (!ids.has(name)) ids.set(name, id);
    all.push(id);
    await runtime.create({
      module: {
        ...module,
        id,
        sessionId: 'session-1',
        processingMode: processingMode ?? module.processingMode,
      },
      mapping: mapping!,
      isTrusted: true,
    });
  }
  for (const id of all) runtime.start(id);
  await clock.endTurn();
  return {
    clock,
    topics,
    runtime,
    events,
    ids,
    values: (topic) =>
      topics.published.filter((record) => record.topic === topic).map(({ value }) => value),
  };
}
