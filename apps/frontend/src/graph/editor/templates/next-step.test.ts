import { expect, it } from 'vitest';
import { aSession } from '../../../sessions/testing/a-session.ts';
import { graphOf } from '../../model/graph-of.ts';
import { aGraphOf, aModule } from '../../model/testing/small-graph.ts';
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

it('does not ask for inputs that have defaults', () => {
  const graph = withModule({});
  const [id, node] = [...graph.nodes].find(([, { kind }]) => kind === 'module')!;
  const ports = node.ports.map((port) =>
    port.direction === 'in' ? { ...port, defaultJson: '{"double":1}' } : port,
  );
  const nodes = new Map([...graph.nodes, [id, { ...node, ports }]]);
  expect(nextStep({ ...graph, nodes })).toContain('pull the output');
});

it('leads from a module to its input, its output and the start', () => {
  expect(nextStep(withModule({}))).toContain('drag a topic');
  expect(nextStep(withModule({ inputMappings }))).toContain('output');
  expect(nextStep(withModule({ inputMappings, outputMappings }))).toBe('Next: press Start.');
});

it('stays at the input of a module while another module has a wire', () => {
  const modules = [
    aModule('low-pass', { value: 'double' }, { smoothed: 'double' }),
    aModule('clock', { waveHz: 'double' }, { sine: 'double' }),
  ];
  const graph = aGraphOf(modules, { 'low-pass.smoothed': '/a', 'clock.waveHz': '/a' });
  expect(nextStep(graph)).toContain('input “value” of low-pass');
  expect(nextStep(graph, 'keys')).toContain('input');
});

it('names the output of another module that fits, before a topic is there', () => {
  const modules = [
    aModule('low-pass', { value: 'double' }, { smoothed: 'double' }),
    aModule('clock', {}, { sine: 'double', tick: 'bool' }),
  ];
  const step = nextStep(aGraphOf(modules));
  expect(step).toBe('Next: pull a wire from “sine” of clock to the input “value” of low-pass.');
  // Its own output, or one behind it, would be a loop.
  expect(nextStep(aGraphOf(modules.slice(0, 1)))).toContain('drag a topic onto');
});

it('names the button that is there', () => {
  const graph = withModule({ inputMappings, outputMappings });
  expect(nextStep(graph, 'pointer', 'Save and start')).toBe('Next: press Save and start.');
  expect(nextStep(graph, 'list', 'Save and start')).toBe('Next: press Save and start.');
});

it('says which keys do it to a user who works with keys', () => {
  expect(nextStep(withModule({}), 'keys')).toMatch(/low-pass with the arrow keys.* L .* its input/);
  expect(nextStep(withModule({ inputMappings }), 'keys')).toMatch(/ L .* its output/);
  expect(nextStep(withModule({ inputMappings, outputMappings }), 'keys')).toBe(
    'Next: press Ctrl Enter to start.',
  );
});

it('says what to press in the list', () => {
  const step = (graph: Parameters<typeof nextStep>[0]) => nextStep(graph, 'list');
  const topic = aGraphOf([], {});
  expect(step(topic)).toBeUndefined();
  expect(step(withModule({}))).toBe(
    'Next: press the input “value” of low-pass, and choose its topic.',
  );
  expect(step(withModule({ inputMappings }))).toBe(
    'Next: press the output “smoothed” of low-pass, and choose a topic.',
  );
  expect(step(withModule({ inputMappings, outputMappings }))).toBe('Next: press Start.');
});
