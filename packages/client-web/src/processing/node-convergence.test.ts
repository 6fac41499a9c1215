import { SessionState } from '@ubii/proto';
import type { Init, Session } from '@ubii/proto';
import { settle } from '@ubii/timing/testing';
import { expect, it } from 'vitest';
import { createNodeWorld, rest, sessionOf, timesTen } from '../testing/node-world.ts';

/** Numbers that look random and are the same in every run. */
function numbersFrom(seed: number): (below: number) => number {
  let state = seed * 2_654_435_761 + 1;
  return (below) => {
    state = (state * 1_664_525 + 1_013_904_223) % 4_294_967_296;
    return Math.floor((state / 4_294_967_296) * below);
  };
}

const SESSIONS = ['s0', 's1', 's2'];

/** The last ones once ended with a report that got lost. */
const RUNS = [
  ...Array.from({ length: 60 }, (_, seed) => seed),
  71,
  81,
  135,
  136,
  145,
  188,
  212,
  253,
];

it.each(RUNS)(
  'a node has in the end what the sessions want, and has said so, run %i',
  async (seed) => {
    const random = numbersFrom(seed + 1);
    const world = await createNodeWorld();
    const { master, sessions, client, clock, node } = world;
    const wanted = new Map<string, { session: Init<Session>; isActive: boolean }>();

    const draft = (id: string): Init<Session> => {
      const modules = Array.from({ length: random(4) }, (_, i) => ({
        ...timesTen(random(5) === 0 ? 'other' : client.id, `${id}-m${i}`),
        ...(random(3) === 0 ? { onProcessingStringified: '() => {}' } : {}),
        ...(random(8) === 0 ? { onCreatedStringified: '() => { throw new Error("no"); }' } : {}),
      }));
      return { ...sessionOf(...modules), id };
    };
    const act = async (): Promise<void> => {
      const id = SESSIONS[random(SESSIONS.length)]!;
      const known = wanted.get(id);
      switch (random(8)) {
        case 0:
        case 1: {
          if (known?.isActive === true) return;
          const session = draft(id);
          wanted.set(id, { session, isActive: true });
          sessions.start(session);
          return;
        }
        case 2:
          if (known?.isActive !== true) return;
          wanted.set(id, { ...known, isActive: false });
          sessions.stop(id);
          return;
        case 3: {
          if (known?.isActive !== true) return;
          const session = draft(id);
          wanted.set(id, { session, isActive: true });
          sessions.change(
            session,
            random(3) === 0 ? SessionState.SESSION_PAUSED : SessionState.SESSION_RUNNING,
          );
          return;
        }
        case 4:
          master.drop();
          return;
        case 5:
          master.restart();
          return;
        case 6:
          return clock.advance(random(2_000));
        default:
          for (let i = random(4); i > 0; i--) await settle();
      }
    };
    for (let step = 0; step < 40; step++) await act();
    await clock.advance(60_000);
    await rest();

    expect(client.state.status).toBe('connected');
    const assigned = [...wanted.values()]
      .filter(({ isActive }) => isActive)
      .flatMap(({ session }) => session.processingModules ?? [])
      .filter(({ nodeId }) => nodeId === client.id);
    expect(node.instances.map(({ id }) => id).sort()).toEqual(
      assigned.map(({ id }) => String(id)).sort(),
    );
    const healthy = assigned.filter(({ onCreatedStringified }) => !onCreatedStringified);
    for (const { id } of node.instances) {
      const last = sessions.told.findLast((each) => each.endsWith(` ${id}`));
      if (healthy.some((module) => module.id === id)) expect(last).toBe(`add ${id}`);
      else expect(last).not.toBe(`add ${id}`);
    }
    for (const each of new Set(sessions.told.map((one) => one.split(' ')[1]!))) {
      if (node.instances.some(({ id }) => id === each)) continue;
      expect(sessions.told.findLast((one) => one.endsWith(` ${each}`))).toBe(`remove ${each}`);
    }
  },
);
