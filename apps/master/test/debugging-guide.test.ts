import { readFileSync } from 'node:fs';
import { fromJson, type ModuleEvent, type Session } from '@ubii/proto';
import { expect, it } from 'vitest';
import { codes, SessionWorld, TOPICS } from './sessions/session-world.ts';

const guide = readFileSync(
  new URL('../../../docs/guides/debugging-a-session.md', import.meta.url),
  'utf8',
);
const [, first = ''] = /```json\n([\s\S]*?)^```/m.exec(guide) ?? [];
/** The outputs shown in the guide. */
const outputs = [...guide.matchAll(/```text\n(.*)\n```/g)].map(([, line]) => line);
const changes = [...guide.matchAll(/```diff\n-(.*)\n\+(.*)\n```/g)];

/** The session of the guide after some of its changes. */
function sessionAfter(count: number): Session {
  const text = changes.slice(0, count).reduce((session, [, before = '', after = '']) => {
    expect(session).toContain(`${before}\n`);
    return session.replace(before, () => after);
  }, first);
  return fromJson('ubii.sessions.Session', JSON.parse(text));
}

async function createWorld(count: number) {
  const world = await SessionWorld.create();
  const watcher = await world.master.extension('watcher');
  const session = await world.ask(TOPICS.start, sessionAfter(count));
  await watcher.subscribe({ subscribeTopics: [`/ubii/session/${session.id}/events`] });
  const pass = async (seconds: number): Promise<void> => {
    for (let i = 0; i < seconds * 20; i++) await world.master.pass(50);
  };
  const events = (): ModuleEvent[] =>
    watcher.takeRecords().flatMap(({ format, value }) => (format === 'moduleEvent' ? [value] : []));
  return { world, session, pass, events };
}

it('has four changes, one for each fault', () => {
  expect(changes).toHaveLength(4);
});

it('is refused for the misspelt input, as it is first', async () => {
  const world = await SessionWorld.create();
  const { problems } = await world.refusal(TOPICS.start, sessionAfter(0));
  const [problem] = problems.filter(({ isError }) => isError);
  expect(problem?.code).toBe('unknown_input');
  expect(outputs).toContain(problem?.message);
});

it('fails in line 3 before the first record, after the first change', async () => {
  const { world, session, pass, events } = await createWorld(1);
  await pass(3);
  expect(codes((await world.get(session)).extension?.problems)).toContain('module_run_failed');
  const [event] = events();
  expect(guide).toContain(`\`${event?.phase}:${event?.line}\``);
  // The engine's own words stand behind the advice.
  expect(outputs).toContain(event?.message.replace(/ \(TypeError: .*/, ''));
});

it('says what the output lacks, after the second change', async () => {
  const { world, pass, events } = await createWorld(2);
  world.ada.publish('/room/loudness', 'double', 1);
  await pass(2);
  expect(await world.value('/room/loudness_mean')).toBeUndefined();
  expect(outputs).toContain(events()[0]?.message);
});

it.each([
  ['less than the mean, after the third change', 3, expect.closeTo(1.05, 1) as number],
  ['the mean, after the fourth change', 4, 2],
])('publishes %s', async (_result, count, mean) => {
  const { world, pass } = await createWorld(count);
  world.ada.publish('/room/loudness', 'double', 1);
  await pass(5);
  world.ada.publish('/room/loudness', 'double', 3);
  await pass(0.1);
  expect(await world.value('/room/loudness_mean')).toEqual(mean);
});
