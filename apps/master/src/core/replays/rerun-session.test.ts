import { Re2Patterns } from '@ubii/patterns/re2';
import {
  decode,
  encode,
  MuxIdentity,
  type Component,
  type Init,
  type Session,
  type TopicMux,
} from '@ubii/proto';
import { recordedDevice } from '@ubii/recording/testing';
import { expect, it } from 'vitest';
import { rerunSession } from './rerun-session.ts';

const patterns = new Re2Patterns();
const DEVICES = [
  recordedDevice('phone', 'ada', [
    { name: 'tilt', topic: '/ada/tilt', format: 'vector3', tags: ['sensor', 'motion'] },
    { name: 'vibrate', topic: '/ada/vibrate', direction: 'subscriber', tags: ['sensor'] },
  ]),
  recordedDevice('wall', 'ben', [{ name: 'light', topic: '/light', tags: ['sensor'] }]),
];

function muxOf(topicMux: Init<TopicMux>) {
  const message: Init<Session> = {
    processingModules: [{ name: 'm' }],
    ioMappings: [{ processingModuleName: 'm', inputMappings: [{ inputName: 'in', topicMux }] }],
  };
  const recorded = decode('ubii.sessions.Session', encode('ubii.sessions.Session', message));
  const rerun = rerunSession(recorded, {
    inputPrefix: '/p/in',
    outputPrefix: '/p/out',
    patterns,
    replayId: 'r',
    devices: DEVICES,
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

it.each<[Init<Component>, string[]]>([
  [{ tags: ['sensor'] }, ['/ada/tilt', '/light']],
  [{ tags: ['motion', 'sensor'] }, ['/ada/tilt']],
  [{ messageFormat: 'vector3' }, ['/ada/tilt']],
  [{ name: 'light' }, ['/light']],
  [{ deviceId: 'wall' }, ['/light']],
])('[RP-42] selects recorded components by %j', (component, topics) => {
  const { mux, selected, readsTopic, emptyInputs } = muxOf({ component, topicGlob: '/**' });
  expect(selected).toEqual([{ tag: 'replay r 0', topics: topics.map((topic) => `/p/in${topic}`) }]);
  expect(mux.component).toMatchObject({ tags: ['replay r 0'], name: '', messageFormat: '' });
  const all = ['/ada/tilt', '/ada/vibrate', '/light', '/other'];
  expect(all.filter(readsTopic)).toEqual(topics);
  expect(emptyInputs).toEqual([]);
});

it('[RP-42] names inputs of which no recorded component fits', () => {
  expect(muxOf({ component: { name: 'heart rate' } }).emptyInputs).toEqual(['in']);
  expect(muxOf({ topicGlob: '/**' }).emptyInputs).toEqual([]);
});

it('[RP-43] gives topics as identities as they were recorded', () => {
  const { mux } = muxOf({ topicGlob: '/**', identitySource: MuxIdentity.MUX_IDENTITY_TOPIC });
  const found = patterns.compile(mux.identityMatchPattern).match('/p/in/ada/tilt');
  expect(found?.[mux.identityGroup]).toBe('/ada/tilt');
});

it('[RP-43] finds the same identities below the prefix', () => {
  const { mux } = muxOf({ topicGlob: '/*/tilt', identityMatchPattern: '/([^/]+)/' });
  expect(mux.topicGlob).toBe('/p/in/*/tilt');
  expect(patterns.compile(mux.identityMatchPattern).match('/p/in/ada/tilt')?.[1]).toBe('ada');
});
