import { expect, it } from 'vitest';
import { aSession } from '../../sessions/testing/a-session.ts';
import { cardSource } from './card-source.ts';

/** A session with one module, whose outputs go to topics of their names. */
function withOutputs(outputs: Readonly<Record<string, string>>) {
  const names = Object.keys(outputs);
  const json = {
    processingModules: [
      {
        id: 'module',
        name: 'module',
        outputs: names.map((name) => ({ internalName: name, messageFormat: outputs[name] })),
      },
    ],
    ioMappings: [
      {
        processingModuleId: 'module',
        outputMappings: names.map((name) => ({ outputName: name, topic: `/lab/${name}` })),
      },
    ],
  };
  return aSession({ json });
}
const nobody = (): number => 0;

it('shows the last topic with pictures, whatever else there is', () => {
  const session = withOutputs({ edges: 'image2D', grey: 'image2D', count: 'double' });
  expect(cardSource(session, nobody)).toEqual({ kind: 'picture', topic: '/lab/grey' });
});

it('shows the most watched topic with numbers, of equals the last one', () => {
  const session = withOutputs({ wave: 'double', place: 'vector2', said: 'string' });
  expect(cardSource(session, nobody)).toMatchObject({ topic: '/lab/place', label: 'place' });
  expect(cardSource(session, (topic) => Number(topic === '/lab/wave'))).toEqual({
    kind: 'line',
    topic: '/lab/wave',
    format: 'double',
    label: 'wave',
  });
});

it('shows the graph of a session without pictures and numbers', () => {
  expect(cardSource(withOutputs({ said: 'string' }), nobody)).toEqual({ kind: 'graph' });
  expect(cardSource(withOutputs({}), nobody)).toEqual({ kind: 'graph' });
});
