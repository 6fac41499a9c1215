import { BridgeMappingsOfClients } from '../bridges/bridge-mappings.ts';
import type { ClientArea } from './clients.ts';
import type { Foundation } from './foundation.ts';
import type { SessionArea } from './sessions.ts';
import type { MasterPorts } from './settings.ts';

/** Bridges to other systems, which are clients. */
export type BridgeArea = ReturnType<typeof createBridges>;

export type BridgeAreaContext = Pick<MasterPorts, 'clock'> &
  Pick<Foundation, 'limits' | 'onClose'> &
  Pick<ClientArea, 'clients'> &
  Pick<SessionArea, 'reports'>;

export function createBridges(context: BridgeAreaContext) {
  const bridgeMappings = new BridgeMappingsOfClients(context);
  context.reports.onMessage.add((client, { bridgeAnswer }) => {
    if (bridgeAnswer !== undefined) bridgeMappings.handleAnswer(client, bridgeAnswer);
  });
  context.onClose.add(() => bridgeMappings.close());
  return { bridgeMappings };
}
