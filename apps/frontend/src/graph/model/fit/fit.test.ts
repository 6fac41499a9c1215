import { EXAMPLE_SESSIONS, moduleLibrary } from '@ubii/modules';
import { fromJson } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { graphOf } from '../graph-of.ts';
import type { Graph } from '../graph.ts';
import { muxerNode, topicNode } from '../make-node.ts';
import { aGraphOf, aModule, ref } from '../testing/small-graph.ts';
import type { Fit } from './adapter.ts';
import { fieldsOf } from './fields.ts';
import { fitOf } from './fit-of.ts';
import { globOfAlike } from './offers.ts';

const library = moduleLibrary();
const modules = [
  aModule('pose', {}, { pose: 'pose3D', points: 'vector2[]' }),
  aModule('mirror', { pointer: 'vector2', size: 'int32' }, { mirrored: 'vector2', x: 'double' }),
  aModule('all', { points: 'vector2[]', any: '' }, { spread: 'vector2[]' }),
];
const graph = aGraphOf(modules, { 'mirror.pointer': '/t', 'mirror.mirrored': '/u' });

const fit = (from: string, to: string, where: Graph = graph): Fit =>
  fitOf(where, ref(where, from), ref(where, to), library);
const words = (one: Fit): string[] =>
  one.fits ? ['fits'] : [one.reason, ...one.offers.map(({ kind, label }) => `${kind}: ${label}`)];

describe('a wire', () => {
  it('is compatible between equal formats, numbers, and unknown formats [PM-3] [PM-31]', () => {
    expect(fit('mirror.mirrored', 'mirror.pointer')).toEqual({ fits: true });
    expect(fit('mirror.x', 'mirror.size')).toEqual({ fits: true });
    expect(fit('pose.pose', 'all.any')).toEqual({ fits: true });
  });

  it('between formats that differ is offered a part of the value, or a module', () => {
    expect(words(fit('pose.pose', 'mirror.size')).slice(0, 3)).toEqual([
      'pose · pose outputs pose3D, but mirror · size expects int32.',
      'field: position.x',
      'field: position.y',
    ]);
    expect(words(fit('mirror.x', 'mirror.pointer'))).toContain('module: merge-vector2 · vector');
    expect(words(fit('pose.pose', 'mirror.pointer'))).toEqual([
      'pose · pose outputs pose3D, but mirror · pointer expects vector2.',
    ]);
  });

  it('to a list is offered a muxer of the topic and of those like it [PM-40]', () => {
    const uuid = '0f8fad5b-d9cb-469f-a165-70867728950e';
    const topic = topicNode(`/${uuid}/phone/touch`);
    const nodes = new Map([...graph.nodes, [topic.id, topic]]);
    const from = { node: topic.id, port: 'out' };
    const to = ref(graph, 'all.points');
    expect(words(fitOf({ ...graph, nodes }, from, to, library))).toEqual([
      `/${uuid}/phone/touch outputs single records, but all · points expects a list.`,
      'muxer: Muxer of /*/phone/touch',
      `muxer: Muxer of /${uuid}/phone/touch`,
    ]);
  });

  it('from a list to one topic is offered a demuxer [PM-45]', () => {
    const one = fitOf(graph, ref(graph, 'pose.points'), { node: 'topic:/u', port: 'in' }, library);
    expect(words(one)).toEqual([
      'pose · points outputs a list of records, but /u expects single records.',
      'demuxer: Demuxer to /u/…',
    ]);
  });

  it('from list to list needs a topic for each element', () => {
    expect(words(fit('pose.points', 'all.points'))).toEqual([
      'pose · points outputs a list. Connect it to all · points through one topic for each element.',
      'spread: One topic for each element',
    ]);
  });

  it('from a muxer fits lists, and modules that do not say what is one [SE-4]', () => {
    const mux = muxerNode(fromJson('ubii.devices.TopicMux', { id: 'm', dataType: 'vector2' }));
    const nodes = new Map([...graph.nodes, [mux.id, mux]]);
    const where = { ...graph, nodes };
    const from = { node: mux.id, port: 'out' };
    expect(fitOf(where, from, ref(graph, 'all.points'))).toEqual({ fits: true });
    expect(fitOf(where, from, ref(graph, 'mirror.pointer'))).toEqual({ fits: true });
    expect(fitOf(where, from, ref(graph, 'all.any')).fits).toBe(false);
  });

  it('that no session can say is refused with what to do', () => {
    const from = { node: 'topic:/t', port: 'out' };
    expect(words(fitOf(graph, from, { node: 'topic:/u', port: 'in' }))).toEqual([
      'Topics get values from modules. Add a module between the two topics.',
    ]);
    expect(words(fitOf(graph, from, { node: 'gone', port: 'in' }))).toEqual([
      'One end of the wire was deleted.',
    ]);
    expect(words(fit('mirror.x', 'mirror.mirrored'))[0]).toContain('Both ends are outputs');
  });

  it('may be asked for from either end', () => {
    expect(fit('mirror.pointer', 'mirror.mirrored')).toEqual({ fits: true });
  });

  it('fits everywhere in the examples', () => {
    for (const example of Object.values(EXAMPLE_SESSIONS)) {
      const session = fromJson('ubii.sessions.Session', example);
      const processingModules = session.processingModules.map((module, index) => ({
        ...library.find(({ name }) => name === module.name)!,
        id: `${index}`,
      }));
      const one = graphOf({ ...session, processingModules });
      expect(one.wires.size).toBeGreaterThan(0);
      for (const { from, to } of one.wires.values()) {
        expect(fitOf(one, from, to)).toEqual({ fits: true });
      }
    }
  });
});

describe('parts of a value', () => {
  it('are found with their formats', () => {
    expect(fieldsOf('pose3D').map(({ path, format }) => `${path}: ${format}`)).toEqual([
      'position: vector3',
      'quaternion: quaternion',
      'position.x: double',
      'position.y: double',
      'position.z: double',
      'quaternion.x: double',
      'quaternion.y: double',
      'quaternion.z: double',
      'quaternion.w: double',
    ]);
    expect(fieldsOf('vector2List').map(({ path }) => path)).toEqual([
      'elements.0',
      'elements.0.x',
      'elements.0.y',
    ]);
    expect(fieldsOf('double')).toEqual([]);
  });
});

describe('topics alike', () => {
  it('differ in ids', () => {
    expect(globOfAlike('/0f8fad5b-d9cb-469f-a165-70867728950e/a/b')).toBe('/*/a/b');
    expect(globOfAlike('/a/b')).toBeUndefined();
  });
});
