import { fromJson, type ProcessingModule } from '@ubii/proto';
import { expect, it } from 'vitest';
import { applyCommand } from '../commands/apply-command.ts';
import { graphOf } from '../graph-of.ts';
import type { Graph, ModuleNode } from '../graph.ts';
import { aModule, aSessionOf } from '../testing/small-graph.ts';
import { graphProblems } from './graph-problems.ts';
import { moduleFaults } from './module-faults.ts';

const ON_INPUT = { triggerOnInput: { minDelayMs: 0, allInputsNeedUpdate: false } };
const AT_RATE = { frequency: { hertz: 30 } };

/** A module whose inputs have these defaults; null: none. */
function withDefaults(
  name: string,
  defaults: Readonly<Record<string, number | null>>,
  processingMode: object = ON_INPUT,
): ProcessingModule {
  const ios = Object.fromEntries(Object.keys(defaults).map((input) => [input, 'double']));
  const module = aModule(name, ios, { out: 'double' });
  const mode = fromJson('ubii.processing.ProcessingModule', { processingMode }).processingMode;
  const inputs = module.inputs.map((io) => {
    const value = defaults[io.internalName];
    return value === null ? io : { ...io, defaultJson: JSON.stringify({ double: value }) };
  });
  return { ...module, inputs, ...(mode && { processingMode: mode }) };
}

const running = { isRunning: true, isSilent: () => false };
const codesOf = (graph: Graph, state = running): string[] =>
  [...moduleFaults(graph, state)].map(({ code, port }) => `${code} ${port}`);
const MAP = withDefaults('map', { value: null, inMin: 0, inMax: 1 });

it('a module that runs on input waits for its main input while nothing is wired', () => {
  const graph = graphOf(aSessionOf([MAP]));
  const [problem] = moduleFaults(graph, running);
  expect(problem).toMatchObject({
    code: 'input_required',
    isError: false,
    node: 'module:map',
    port: 'in:value',
    message: 'The input "value" is not connected. The module runs when it arrives.',
    consequence: 'Waits for value',
  });
  const session = aSessionOf([MAP]);
  const around = { modules: undefined, nodes: undefined, writers: new Map(), ...running };
  expect(graphProblems(graph, session, around).all).toHaveLength(1);
});

it('nothing waits in a session that does not run, or when the module is off', () => {
  const graph = graphOf(aSessionOf([MAP]));
  expect(codesOf(graph, { ...running, isRunning: false })).toEqual([]);
  const muted = { kind: 'setStanding', nodes: ['module:map'], standing: 'muted' } as const;
  expect(codesOf(applyCommand(graph, muted).graph)).toEqual([]);
});

it('a module with a wire, a fixed value or a default at its main input does not wait', () => {
  expect(codesOf(graphOf(aSessionOf([MAP], { 'map.value': '/t' })))).toEqual([]);
  const constant = { 'map.value': { constantJson: '{"double":3}' } };
  expect(codesOf(graphOf(aSessionOf([MAP], constant)))).toEqual([]);
  expect(codesOf(graphOf(aSessionOf([withDefaults('clock', { waveHz: 1 })])))).toEqual([]);
});

it('a module that works without its main input does not wait', () => {
  const mix = withDefaults('mix', { a: null, b: null });
  expect(codesOf(graphOf(aSessionOf([mix], { 'mix.b': '/t' })))).toEqual([]);
  const silent = { isRunning: true, isSilent: () => true };
  expect(codesOf(graphOf(aSessionOf([mix], { 'mix.b': '/t' })), silent)).toEqual([]);
});

it('a module that runs by itself waits only when it outputs nothing', () => {
  const speed = withDefaults('speed', { position: null }, AT_RATE);
  const graph = graphOf(aSessionOf([speed]));
  expect(codesOf(graph)).toEqual([]);
  const isSilent = ({ module }: ModuleNode): boolean => module.name === 'speed';
  const [problem] = moduleFaults(graph, { isRunning: true, isSilent });
  expect(problem?.message).toBe(
    'The input "position" is not connected, and the module outputs nothing without it.',
  );
});

it('an empty range is named, at defaults and at fixed values', () => {
  const one = { 'map.value': '/t', 'map.inMin': { constantJson: '{"double":1}' } };
  const [problem] = moduleFaults(graphOf(aSessionOf([MAP], one)), { isRunning: false });
  expect(problem).toMatchObject({
    code: 'empty_range',
    node: 'module:map',
    port: 'in:inMin',
    message: 'inMin and inMax are both 1: the range is empty. Set two different values.',
    consequence: 'Empty range: inMin = inMax',
  });
  expect(codesOf(graphOf(aSessionOf([MAP], { ...one, 'map.inMax': '/limit' })))).toEqual([]);
});
