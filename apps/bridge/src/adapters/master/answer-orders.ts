import type { UbiiClient } from '@ubii/client-web/node';
import { ServiceError } from '@ubii/proto';
import type { BridgeMappings, BridgeOrder, Init } from '@ubii/proto';
import { encodeNodeMessageFrame } from '@ubii/proto/wire';

/** Answers what the master asks the bridge, one order after the other. [BR-80] @returns ends it */
export function answerOrders(
  client: UbiiClient,
  answer: (order: BridgeOrder) => Promise<Init<BridgeMappings>>,
): () => void {
  const answerOne = async (order: BridgeOrder): Promise<void> => {
    const { number } = order;
    try {
      const mappings = await answer(order);
      client.sendNodeMessage(encodeNodeMessageFrame({ bridgeAnswer: { number, mappings } }));
    } catch (cause) {
      const error = cause instanceof ServiceError ? cause : internal(cause);
      client.sendNodeMessage(
        encodeNodeMessageFrame({ bridgeAnswer: { number, error: error.toWire() } }),
      );
    }
  };
  let turn: Promise<void> = Promise.resolve();
  return client.onNodeMessage(({ bridgeOrder: order }) => {
    if (order !== undefined) turn = turn.then(() => answerOne(order));
  });
}

function internal(cause: unknown): ServiceError {
  return new ServiceError('internal', `The bridge failed: ${(cause as Error).message}`);
}
