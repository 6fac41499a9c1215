import type { ProcessingModule } from '@ubii/proto';
import { nodeName } from '../commands/command-label.ts';
import type { GraphCommand } from '../commands/graph-command.ts';
import type { GraphNode, ModuleNode } from '../graph.ts';
import { constantNode, demuxerNode, moduleNode, muxerNode, topicNode } from '../make-node.ts';
import type { Conflict } from './conflict.ts';
import { mergeEntries, mergeMembers, threeWay } from './three-way.ts';
import { wishedNode } from './wished-node.ts';

/** Receives the conflicts of a node. */
type Report = (what: string, theirs: unknown, mine: unknown, takeTheirs: GraphCommand) => void;

/** Merges the changes of two users to a node, property by property. Positions cause no conflicts. */
export function mergeNode(
  base: GraphNode,
  mine: GraphNode,
  theirs: GraphNode,
  conflicts: Conflict[],
): GraphNode {
  const id = mine.id;
  const report: Report = (what, theirValue, myValue, takeTheirs) => {
    conflicts.push({
      node: id,
      wire: undefined,
      what: `${what} of ${nodeName(mine)}`,
      theirs: theirValue,
      mine: myValue,
      takeTheirs,
      takeMine: undefined,
    });
  };
  const look = lookOf(base, mine, theirs);
  if (mine.kind === 'module' && theirs.kind === 'module' && base.kind === 'module') {
    return mergeModules(base, mine, theirs, look, report);
  }
  return { ...mergePlain(base, mine, theirs, report), ...look };
}

type Look = Pick<GraphNode, 'position' | 'size' | 'isCollapsed' | 'frame'>;

function lookOf(base: GraphNode, mine: GraphNode, theirs: GraphNode): Look {
  const pick = <K extends keyof Look>(member: K): GraphNode[K] =>
    threeWay(base[member], mine[member], theirs[member]).value;
  return {
    position: pick('position'),
    size: pick('size'),
    isCollapsed: pick('isCollapsed'),
    frame: pick('frame'),
  };
}

const MODULE_WORDS: Partial<Record<keyof ProcessingModule, string>> = {
  name: 'The name',
  nodeId: 'The place',
  processingMode: 'The mode',
  inputs: 'The inputs',
  outputs: 'The outputs',
  onProcessingStringified: 'The code',
};

function mergeModules(
  base: ModuleNode,
  mine: ModuleNode,
  theirs: ModuleNode,
  look: Look,
  report: Report,
): ModuleNode {
  const node = mine.id;
  const module = mergeMembers(
    asWished(base.module),
    asWished(mine.module),
    asWished(theirs.module),
    (member, theirValue, myValue) => {
      // Properties that only the master sets have the master's value.
      if (MASTERS.has(member)) return;
      report(MODULE_WORDS[member] ?? `The ${member}`, theirValue, myValue, {
        kind: 'setModule',
        node,
        changes: { [member]: theirValue },
      });
    },
  );
  for (const member of MASTERS) Object.assign(module, { [member]: theirs.module[member] });
  // When the master chooses the node, keep its choice.
  if (module.nodeId === wishedNode(theirs.module)) {
    const { nodeId, extension } = theirs.module;
    const replaceable = extension?.replaceable ?? false;
    const merged = module.extension && { ...module.extension, replaceable };
    Object.assign(module, { nodeId, extension: merged ?? extension });
  }
  const constants = mergeEntries(
    base.constants,
    mine.constants,
    theirs.constants,
    (input, json, myJson) =>
      report(`The value ${input}`, json, myJson, { kind: 'setConstant', node, input, json }),
  );
  const standing = threeWay(base.standing, mine.standing, theirs.standing);
  if (standing.kind === 'conflict') {
    const takeTheirs = { kind: 'setStanding', nodes: [node], standing: theirs.standing } as const;
    report('The bypass', theirs.standing, mine.standing, takeTheirs);
  }
  const names = (direction: 'in' | 'out'): string[] =>
    [...mine.ports, ...theirs.ports].flatMap((port) =>
      port.direction === direction && !port.isDeclared ? port.name : [],
    );
  return moduleNode(module, {
    ...look,
    id: node,
    constants,
    standing: standing.value,
    mappedInputs: names('in'),
    mappedOutputs: names('out'),
  });
}

const asWished = (module: ProcessingModule): ProcessingModule => ({
  ...module,
  nodeId: wishedNode(module),
});

const MASTERS: ReadonlySet<keyof ProcessingModule> = new Set(['status', 'sessionId'] as const);

function mergePlain(
  base: GraphNode,
  mine: GraphNode,
  theirs: GraphNode,
  report: Report,
): GraphNode {
  const node = mine.id;
  if (mine.kind === 'muxer' && theirs.kind === 'muxer' && base.kind === 'muxer') {
    const mux = mergeMembers(base.mux, mine.mux, theirs.mux, (member, theirValue, myValue) =>
      report(`The ${member}`, theirValue, myValue, {
        kind: 'setMuxer',
        node,
        changes: { [member]: theirValue },
      }),
    );
    return muxerNode(mux, { id: node });
  }
  if (mine.kind === 'demuxer' && theirs.kind === 'demuxer' && base.kind === 'demuxer') {
    const demux = mergeMembers(
      base.demux,
      mine.demux,
      theirs.demux,
      (member, theirValue, myValue) =>
        report(`The ${member}`, theirValue, myValue, {
          kind: 'setDemuxer',
          node,
          changes: { [member]: theirValue },
        }),
    );
    return demuxerNode(demux, { id: node });
  }
  if (mine.kind === 'constant' && theirs.kind === 'constant' && base.kind === 'constant') {
    const json = threeWay(base.json, mine.json, theirs.json);
    if (json.kind === 'conflict') {
      report('The value', theirs.json, mine.json, { kind: 'setValue', node, json: theirs.json });
    }
    const name = threeWay(base.name, mine.name, theirs.name).value;
    return constantNode(node, json.value, { name });
  }
  if (mine.kind === 'topic' && theirs.kind === 'topic' && base.kind === 'topic') {
    return topicNode(mine.topic, {
      format: threeWay(base.format, mine.format, theirs.format).value,
    });
  }
  if (mine.kind === 'comment' && theirs.kind === 'comment' && base.kind === 'comment') {
    const text = threeWay(base.text, mine.text, theirs.text);
    if (text.kind === 'conflict') {
      report('The text', theirs.text, mine.text, { kind: 'setText', node, text: theirs.text });
    }
    return { ...mine, text: text.value };
  }
  if (mine.kind === 'frame' && theirs.kind === 'frame' && base.kind === 'frame') {
    const title = threeWay(base.title, mine.title, theirs.title);
    if (title.kind === 'conflict') {
      report('The title', theirs.title, mine.title, { kind: 'setText', node, text: theirs.title });
    }
    const color = threeWay(base.color, mine.color, theirs.color).value;
    return { ...mine, title: title.value, color };
  }
  return mine;
}
