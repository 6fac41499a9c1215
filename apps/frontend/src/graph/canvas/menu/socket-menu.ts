import { plural } from '@ubii/words';

import { neutralConstant } from '../../model/new-node.ts';
import type { Graph, PortRef } from '../../model/graph.ts';
import { portOf } from '../../model/port-format.ts';
import { wiresAt } from '../../model/wires-of.ts';
import { action, separated, type MenuEntry, type MenuPlace } from './menu-entry.ts';

/** Returns the menu entries for an input or output. */
export function socketMenu(graph: Graph, ref: PortRef, { at }: MenuPlace): MenuEntry[] {
  const port = portOf(graph, ref);
  const node = graph.nodes.get(ref.node);
  if (port === undefined || node === undefined) return [];
  const wires = wiresAt(graph, ref).map(({ id }) => id);
  const isInput = port.direction === 'in';
  const constant = node.kind === 'module' ? node.constants.get(port.name) : undefined;
  const canHold = isInput && node.kind === 'module' && !port.isList && wires.length === 0;
  return separated(
    [action(isInput ? 'Connect from…' : 'Connect to…', { request: { kind: 'add', at, end: ref } })],
    [
      ...(canHold && constant === undefined && port.format !== undefined
        ? [
            action('Set value', {
              command: {
                kind: 'setConstant',
                node: ref.node,
                input: port.name,
                json: neutralConstant(port.format),
              },
              select: [ref.node],
              request: { kind: 'inspect', node: ref.node },
            }),
          ]
        : []),
      ...(canHold && constant !== undefined
        ? [
            action('Use default', {
              command: { kind: 'setConstant', node: ref.node, input: port.name, json: undefined },
            }),
          ]
        : []),
    ],
    wires.length === 0
      ? []
      : [
          action(
            plural(wires.length, 'Disconnect', `Disconnect all ${wires.length}`),
            { command: { kind: 'remove', wires } },
            { isDanger: true },
          ),
        ],
  );
}
