import { canHide } from '../../model/commands/topic-commands.ts';
import type { Graph, GraphNode, ModuleNode } from '../../model/graph.ts';
import { duplicate } from '../../model/selection/clipboard.ts';
import { detach, reconnections, removeAndReconnect } from '../../model/selection/reconnect.ts';
import { wiresOf } from '../../model/wires-of.ts';
import { canCollapse, collapseCommand } from '../../nodes/collapse.ts';
import { lineUpMenu } from './line-up-menu.ts';
import {
  action,
  separated,
  type MenuAction,
  type MenuEntry,
  type MenuPlace,
} from './menu-entry.ts';

/** Returns the menu entries for one or several nodes. */
export function nodesMenu(graph: Graph, ids: readonly string[], place: MenuPlace): MenuEntry[] {
  const nodes = ids.flatMap((id) => graph.nodes.get(id) ?? []);
  const [only] = nodes;
  if (only === undefined) return [];
  const chosen = nodes.map(({ id }) => id);
  return separated(
    nodes.length === 1 ? aboutOne(graph, only) : [],
    copies(graph, nodes, place),
    [...standings(nodes), ...collapsing(nodes)],
    [...wiring(graph, chosen), ...lineUpMenu(graph, nodes, place)],
    place.isTouch ? [action('Select multiple', { request: { kind: 'selectMore' } })] : [],
    removal(graph, chosen),
  );
}

/** Kinds of nodes with a text of their own that can be edited. */
const NAMED: ReadonlySet<GraphNode['kind']> = new Set([
  'topic',
  'muxer',
  'demuxer',
  'constant',
  'frame',
]);

function aboutOne(graph: Graph, node: GraphNode): MenuAction[] {
  const words = NAMED.has(node.kind) ? 'Rename…' : node.kind === 'comment' ? 'Write…' : 'Inspect';
  const inspect = action(
    words,
    { request: { kind: 'inspect', node: node.id } },
    { shortcut: 'Enter' },
  );
  switch (node.kind) {
    case 'module':
      return [
        inspect,
        action('Open module', { request: { kind: 'open module', name: node.module.name } }),
      ];
    case 'topic':
      return [
        inspect,
        action('Open topic', { request: { kind: 'open topic', name: node.topic } }),
        ...(canHide(graph, node)
          ? [action('Show as wire', { command: { kind: 'hideTopic', node: node.id } })]
          : []),
      ];
    case 'frame':
      return [
        inspect,
        action(
          'Remove frame only',
          { command: { kind: 'ungroup', frame: node.id } },
          { shortcut: 'Ctrl Shift G' },
        ),
      ];
    default:
      return [inspect];
  }
}

function copies(graph: Graph, nodes: readonly GraphNode[], { uuid }: MenuPlace): MenuAction[] {
  const ids = nodes.map(({ id }) => id);
  const copy = duplicate(graph, ids, uuid);
  return [
    ...(copy === undefined
      ? []
      : [action('Duplicate', { command: copy.command, select: copy.ids }, { shortcut: 'Ctrl D' })]),
    action('Copy', { request: { kind: 'copy', nodes: ids } }, { shortcut: 'Ctrl C' }),
    action('Cut', { request: { kind: 'cut', nodes: ids } }, { shortcut: 'Ctrl X' }),
  ];
}

function standings(nodes: readonly GraphNode[]): MenuAction[] {
  const modules = nodes.filter((node): node is ModuleNode => node.kind === 'module');
  if (modules.length === 0) return [];
  const ids = modules.map(({ id }) => id);
  return (['bypassed', 'muted'] as const).map((standing) => {
    const isOn = modules.every((node) => node.standing === standing);
    const words = standing === 'bypassed' ? 'Bypass' : 'Mute';
    return action(
      isOn ? 'Enable' : words,
      { command: { kind: 'setStanding', nodes: ids, standing: isOn ? 'active' : standing } },
      { shortcut: words === 'Bypass' ? 'B' : 'M' },
    );
  });
}

function collapsing(nodes: readonly GraphNode[]): MenuAction[] {
  const command = collapseCommand(nodes.filter(canCollapse));
  if (command === undefined) return [];
  return [action(command.isCollapsed ? 'Collapse' : 'Expand', { command }, { shortcut: 'C' })];
}

function wiring(graph: Graph, ids: readonly string[]): MenuAction[] {
  const wires = new Set(
    ids.flatMap((id) => {
      const { in: incoming, out } = wiresOf(graph, id);
      return [...incoming, ...out].map((wire) => wire.id);
    }),
  );
  if (wires.size === 0) return [];
  const leadsOn = reconnections(graph, new Set(ids)).length > 0;
  return [
    ...(leadsOn ? [action('Detach', { command: detach(graph, ids) }, { shortcut: 'X' })] : []),
    action('Disconnect all', { command: { kind: 'remove', wires: [...wires] } }),
  ];
}

function removal(graph: Graph, ids: readonly string[]): MenuAction[] {
  const leadsOn = reconnections(graph, new Set(ids)).length > 0;
  return [
    ...(leadsOn
      ? [
          action(
            'Delete and reconnect',
            { command: removeAndReconnect(graph, ids) },
            { shortcut: 'Shift Del', isDanger: true },
          ),
        ]
      : []),
    action(
      'Delete',
      { command: { kind: 'remove', nodes: ids } },
      { shortcut: 'Del', isDanger: true },
    ),
  ];
}
