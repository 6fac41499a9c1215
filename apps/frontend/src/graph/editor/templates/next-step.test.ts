import { expect, it } from 'vitest';
import { aSession } from '../../../sessions/testing/a-session.ts';
import { graphOf } from '../../model/graph-of.ts';
import { nextStep } from './next-step.ts';

const PORTS = {
  inputs: [{ internalName: 'value', messageFormat: 'double' }],
  outputs: [{ internalName: 'smoothed', messageFormat: 'double' }],
};
const withModule = (mapping: object) =>
  graphOf(
    aSession({
      json: {
        processingModules: [{ id: 'a', name: 'low-pass', ...PORTS }],
        ioMappings: [{ processingModuleId: 'a', ...mapping }],
      },
    }),
  );
const inputMappings = [{ inputName: 'value', topic: '/in' }];
const outputMappings = [{ outputName: 'smoothed', topic: '/out' }];

it('says nothing of an empty graph, which says more', () => {
  expect(
    nextStep(graphOf(aSession({ json: { processingModules: [], ioMappings: [] } }))),
  ).toBeUndefined();
});

it('leads from a module to its input, its output and the start', () => {
  expect(nextStep(withModule({}))).toContain('drag a topic');
  expect(nextStep(withModule({ inputMappings }))).toContain('output');
  expect(nextStep(withModule({ inputMappings, outputMappings }))).toBe('Next: press Start.');
});
