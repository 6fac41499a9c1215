import type { Init, NodeRecorderAnswer, NodeRecorderOrder } from '@ubii/proto';
import { encodeNodeMessageFrame } from '@ubii/proto/wire';
import { NodeRequests, type NodeRequestsContext } from '../nodes/node-requests.ts';

/** What nodes are asked to do for recordings, and their answers. [RC-61] */
export type NodeOrders = NodeRequests<NodeOrder, NodeRecorderAnswer>;

export type NodeOrder = Omit<Init<NodeRecorderOrder>, 'number'>;

export function createNodeOrders(context: NodeRequestsContext): NodeOrders {
  return new NodeRequests(context, {
    noun: 'node',
    encodeFrame: (order, number) => encodeNodeMessageFrame({ recorderOrder: { ...order, number } }),
  });
}
