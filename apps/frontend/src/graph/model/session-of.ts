import { isSameValue, type IOMapping, type Session } from '@ubii/proto';
import { editorDataText } from './editor-data-text.ts';
import { parseEditorData } from './editor-data.ts';
import { graphOf } from './graph-of.ts';
import type { Graph, ModuleNode } from './graph.ts';
import { moduleEnds } from './module-ends.ts';
import { readModules, type MappedModule } from './read-mappings.ts';
import { withDetails, withEditorJson } from './session-details.ts';
import { asideOf } from './standing/detours.ts';
import { restored, setAside } from './standing/set-aside.ts';
import { writeMapping } from './write-mapping.ts';

/**
 * Converts a graph to a session. Everything that the graph does not show, or that is unchanged, is taken from the
 * original session: `sessionOf(graphOf(session), session)` equals the session.
 */
export function sessionOf(graph: Graph, shown: Session): Session {
  const { aside: wasAside } = parseEditorData(shown.extension?.editorJson ?? '');
  if (wasAside.modules.length > 0 && isSameValue(graphOf(shown), graph)) return shown;
  const base = restored(shown, wasAside);
  const before = new Map(readModules(base).map((module) => [module.nodeId, module]));
  const nodes = inOrderOf([...before.keys()], graph);
  const mappings = new Map<number, IOMapping>();
  const added: IOMapping[] = [];
  for (const node of nodes) {
    const old = before.get(node.id);
    const index = old?.mappingIndex ?? -1;
    const mapping = writeMapping(node.module, moduleEnds(graph, node), old, base.ioMappings[index]);
    if (index >= 0 && mapping !== undefined) mappings.set(index, mapping);
    else if (mapping !== undefined) added.push(mapping);
    else if (old === undefined && takesLeftOver(node, base)) added.push(emptyMapping(node));
  }
  const full: Session = {
    ...withDetails(base, graph.details),
    processingModules: nodes.map(({ module }) => module),
    ioMappings: [...keptMappings(base, before, graph, mappings), ...added],
  };
  const aside = asideOf(graph, full);
  const session = setAside(full, aside);
  const text = editorDataText(graph, aside);
  // Keep the original text if it gives the same graph.
  return saysTheSame(session, text) ? session : withEditorJson(session, text);
}

function saysTheSame(session: Session, text: string): boolean {
  const { aside } = parseEditorData(session.extension?.editorJson ?? '');
  return editorDataText(graphOf(session), aside) === text;
}

/** Whether a mapping without a module would be assigned to a new module by its name. [SE-2] */
function takesLeftOver({ module }: ModuleNode, { ioMappings }: Session): boolean {
  return (
    module.id !== '' &&
    ioMappings.some(
      ({ processingModuleId, processingModuleName }) =>
        processingModuleId === '' && processingModuleName === module.name,
    )
  );
}

const emptyMapping = ({ module }: ModuleNode): IOMapping => ({
  processingModuleId: module.id,
  processingModuleName: module.name,
  inputMappings: [],
  outputMappings: [],
});

/** Keeps the order of modules: outputs of a pass are published in it. [SE-41] */
function inOrderOf(ids: readonly string[], graph: Graph): ModuleNode[] {
  const known = new Set(ids);
  const old = ids.map((id) => graph.nodes.get(id));
  const added = [...graph.nodes.values()].filter(({ id }) => !known.has(id));
  return [...old, ...added].filter((node) => node?.kind === 'module');
}

/** Keeps the order of mappings; drops those of removed modules, and keeps those without a module. */
function keptMappings(
  base: Session,
  before: ReadonlyMap<string, MappedModule>,
  graph: Graph,
  mappings: ReadonlyMap<number, IOMapping>,
): IOMapping[] {
  const removed = [...before.values()].filter(({ nodeId }) => !graph.nodes.has(nodeId));
  const removedIndices = new Set(removed.map(({ mappingIndex }) => mappingIndex));
  const removedIds = new Set(removed.map(({ module }) => module.id).filter((id) => id !== ''));
  for (const node of graph.nodes.values()) {
    if (node.kind === 'module') removedIds.delete(node.module.id);
  }
  return base.ioMappings.flatMap((mapping, index) => {
    const written = mappings.get(index);
    if (written !== undefined) return [written];
    const isGone = removedIndices.has(index) || removedIds.has(mapping.processingModuleId);
    return isGone ? [] : [mapping];
  });
}
