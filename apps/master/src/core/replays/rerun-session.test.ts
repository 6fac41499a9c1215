import { Re2Patterns } from '@ubii/patterns/re2';
import { decode, encode, type Init, type Session, type TopicMux } from '@ubii/proto';
import { expect, it } from 'vitest';
import { rerunSession } from './rerun-session.ts';

const patterns = new Re2Patterns();

function muxOf(topicMux: Init<TopicMux>) {
  const message: Init<Session> = {
    processingModules: [{ name: 'm' }],
    ioMappings: [{ processingModuleName: 'm', inputMappings: [{ inputName: 'in', topicMux }] }],
  };
  const recorded = decode('ubii.sessions.Session', encode('ubii.sessions.Session', message));
  const rerun = rerunSession(recorded, {
    ...{ inputPrefix: '/p/in', outputPrefix: '/p/out', patterns },
    isInLibrary: () => true,
  });
  return { ...rerun, mux: rerun.session.ioMappings[0]!.inputMappings[0]!.topicMux! };
}

it.each([
  ['^/a/.*$', ['/a/b'], ['/b/a/c']],
  ['/a/', ['/a/b', '/b/a/c'], ['/b']],
  ['^/a$|^/b$', ['/a', '/b'], ['/c', '/a/b']],
  ['^/(a|b)$|[|]x', ['/a', '/b', '/c|x'], ['/c', '/a/x']],
])('[RP-40] selects below the prefix what %s selects', (topicSelector, selected, others) => {
  const { mux, readsTopic } = muxOf({ topicSelector });
  const moved = patterns.compile(mux.topicSelector);
  for (const topic of selected)
    expect([readsTopic(topic), moved.test(`/p/in${topic}`)]).toEqual([true, true]);
  for (const topic of others)
    expect([readsTopic(topic), moved.test(`/p/in${topic}`)]).toEqual([false, false]);
});

it('[RP-40] names inputs that select components', () => {
  expect(muxOf({ component: { name: 'tilt' } }).emptyInputs).toEqual(['in']);
  expect(muxOf({ topicGlob: '/**' }).emptyInputs).toEqual([]);
});

it('[RP-40] finds the same identities below the prefix', () => {
  const { mux } = muxOf({ topicGlob: '/*/tilt', identityMatchPattern: '/([^/]+)/' });
  expect(mux.topicGlob).toBe('/p/in/*/tilt');
  expect(patterns.compile(mux.identityMatchPattern).match('/p/in/ada/tilt')?.[1]).toBe('ada');
});
