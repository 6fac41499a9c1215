import { RecordingState, ServiceError, type Recording } from '@ubii/proto';
import type { Caller } from '../access/caller.ts';
import { PARTICIPANTS } from '../access/roles.ts';
import type { Client } from '../clients/client.ts';
import type { ClientRegistry } from '../clients/client-registry.ts';
import { isAway } from '../nodes/node-requests.ts';
import { quote } from '../texts/quote.ts';

/** Only who may upload recordings can make them. [RC-60] */
export function mayRecord({ node, access }: Pick<Client, 'node' | 'access'>): boolean {
  return node?.records === true && PARTICIPANTS.some((role) => role === access.role);
}

/** The node that is to record. [RC-60] @throws ServiceError when it cannot */
export function requireRecorder(clients: ClientRegistry, nodeId: string): Client {
  const node = clients.get(nodeId);
  if (node === undefined) {
    throw new ServiceError('not_found', `No client has the id ${quote(nodeId)}.`);
  }
  if (node.node?.records !== true) {
    const text = `The client ${quote(node.label)} does not record. Start a node with --record-dir, or record on the master.`;
    throw new ServiceError('failed_precondition', text);
  }
  if (!mayRecord(node)) {
    const text = `The node ${quote(node.label)} may not upload recordings. Let it join as a participant.`;
    throw new ServiceError('failed_precondition', text);
  }
  if (node.socket === undefined) throw isAway(quote(node.label));
  return node;
}

/**
 * Whether this caller may bring the file of a recording. [RC-63]
 *
 * @param clientId what a caller without a credential says that it is
 * @throws ServiceError when it is not its node, or it still records
 */
export function requireUploader(recording: Recording, clientId: string, caller: Caller): void {
  const from = caller.kind === 'client' ? caller.clientId : clientId;
  if (recording.nodeId !== from) {
    const text = `The file of this recording is uploaded by the node ${quote(recording.nodeName)}, which made it.`;
    throw new ServiceError('permission_denied', text);
  }
  requireEnd(recording);
}

/** @throws ServiceError while it records */
export function requireEnd({ state }: Recording): void {
  if (state !== RecordingState.RECORDING_STATE_RECORDING) return;
  throw new ServiceError(
    'failed_precondition',
    'This recording is running. Stop it before its file is uploaded.',
  );
}
