import { readyPatterns, type PatternSource } from '@ubii/patterns';
import { Re2Patterns } from '@ubii/patterns/re2';
import { FakeClock } from '@ubii/timing/testing';
import type { ClientOptions } from '../core/client/client-options.ts';
import type { ConnectionState } from '../core/connection/connection-state.ts';
import { createUbiiClient } from '../core/client/create-ubii-client.ts';
import type { ClientProblem, UbiiClient } from '../core/client/ubii-client.ts';
import type { MasterWays } from '../core/ports/master-ways.ts';
import { systemUuid } from '../system-uuid.ts';
import { createMemoryServices, createMemoryTopicData } from '../transports/memory.ts';
import type { MemoryMaster } from '../transports/memory.ts';

/** A client on a clock that stands still, with what it reported so far. */
export interface TestClient {
  readonly client: UbiiClient;
  readonly clock: FakeClock;
  readonly states: ConnectionState[];
  readonly problems: ClientProblem[];
}

const GONE: MemoryMaster = {
  handleServiceRequest: () => Promise.reject(new Error('there is no master')),
  openConnection: () => undefined,
};

function waysOf(master: MemoryMaster): MasterWays {
  return { services: createMemoryServices(master), topicData: createMemoryTopicData(master) };
}

/** A client of a master in the same process. Jitter is none, unless the options say otherwise. */
export function createTestClient(
  master: MemoryMaster,
  options: Partial<ClientOptions> & {
    readonly clock?: FakeClock;
    readonly patterns?: PatternSource;
    /** Other masters, by their base URLs. */
    readonly others?: ReadonlyMap<string, MemoryMaster>;
  } = {},
): TestClient {
  const clock = options.clock ?? new FakeClock();
  const client = createUbiiClient(
    { name: 'ada', publishIntervalMs: 0, ...options },
    {
      clock,
      random: options.random ?? (() => 0),
      patterns: options.patterns ?? readyPatterns(new Re2Patterns()),
      uuid: systemUuid,
      // Fails the test run, unless the test expects the error.
      reportError: (error) => void Promise.reject(error),
      master: { url: options.url, ...waysOf(master) },
      ...(options.others && { waysTo: (url) => waysOf(options.others?.get(url) ?? GONE) }),
    },
  );
  const states: ConnectionState[] = [];
  const problems: ClientProblem[] = [];
  client.onState((state) => states.push(state));
  client.onError((problem) => problems.push(problem));
  return { client, clock, states, problems };
}
