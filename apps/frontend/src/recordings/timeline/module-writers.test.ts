import { toJson, type Init, type Session } from '@ubii/proto';
import { expect, it } from 'vitest';
import { moduleWriters, parseSession } from './module-writers.ts';

const recorded = (session: Init<Session>) => ({
  session: JSON.stringify(toJson('ubii.sessions.Session', session)),
});
const module = (id: string, name: string, topic: string): Init<Session> => ({
  processingModules: [{ id, name }],
  ioMappings: [{ processingModuleId: id, outputMappings: [{ outputName: 'out', topic }] }],
});

it('names the modules that write a topic, of all sessions that can be read', () => {
  const sessions = [
    recorded(module('1', 'Classifier', '/label')),
    recorded(module('2', 'Smoother', '/label')),
    { session: 'no JSON' },
    recorded({ ioMappings: [{ processingModuleId: '3', outputMappings: [{ topic: '/gone' }] }] }),
  ];
  const writers = moduleWriters(sessions.flatMap(parseSession));
  expect([...writers]).toEqual([['/label', 'Classifier, Smoother']]);
});
