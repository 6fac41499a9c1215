import { NO_LANGUAGE } from '../library/module-offer.ts';
import type { SessionModule } from './session-module.ts';
import { ProcessingModuleLanguage, type ProcessingModule } from '@ubii/proto';
import { quote } from '../texts/quote.ts';
import { chooseNode } from '../nodes/placement.ts';
import { isJavaScript, offerOf, type Node } from '../nodes/node.ts';
import type { LifeContext } from './life-context.ts';
import { errorProblem } from './problems.ts';

/** Places a module that is to run on a node, or makes it wait for one [SE-30] [SE-31]. */
export function placeModule(context: LifeContext, module: SessionModule): void {
  const { nodes, clock, loadOf } = context;
  const { spec, requestedNodeId } = module;
  const node =
    requestedNodeId === undefined
      ? chooseNode(spec, nodes.list(), loadOf)
      : availableNode(nodes.get(requestedNodeId));
  if (node === undefined) {
    module.handleNodeGone(nodeGone(module, nodes.get(module.nodeId)));
    return;
  }
  module.place(specFor(node, spec), clock.monotonicMs());
}

/** Names the node that would run a module of a stopped session [SE-30]. */
export function assignNode({ nodes, loadOf }: LifeContext, module: SessionModule): void {
  const { spec, requestedNodeId } = module;
  const node =
    requestedNodeId === undefined
      ? chooseNode(spec, nodes.list(), loadOf)
      : nodes.get(requestedNodeId);
  if (node !== undefined) module.assign(specFor(node, spec));
}

/** The specification in the form that this node accepts [SE-2]. */
export function specFor(node: Node, spec: ProcessingModule): ProcessingModule {
  return { ...spec, nodeId: node.id, language: languageFor(node, spec) };
}

/** Existing nodes exit when a language is not theirs: send only languages that they named. */
function languageFor(node: Node, spec: ProcessingModule): ProcessingModuleLanguage {
  if (node.extension === undefined) return offerOf(node, spec.name)?.language ?? NO_LANGUAGE;
  const isCode = spec.onProcessingStringified !== '' && isJavaScript(spec);
  return isCode ? ProcessingModuleLanguage.JS : spec.language;
}

function availableNode(node: Node | undefined): Node | undefined {
  return node?.isAvailable === true ? node : undefined;
}

function nodeGone(module: SessionModule, node: Node | undefined): ReturnType<typeof errorProblem> {
  const nodeName = node === undefined ? 'its node' : `its node ${quote(node.label)}`;
  const message =
    module.requestedNodeId === undefined
      ? `The module ${quote(module.name)} does not run: no connected node can run it. It starts when such a node connects.`
      : `The module ${quote(module.name)} does not run: ${nodeName} is not connected. It starts when the node reconnects.`;
  return errorProblem({
    code: 'node_gone',
    message,
    moduleId: module.id,
    moduleName: module.name,
    nodeId: module.requestedNodeId ?? '',
  });
}
