import {
  findJsonProblems,
  messageDescriptor,
  SERVICES,
  type JsonObject,
  type JsonProblem,
  type MessageDescriptor,
  type MessageType,
  type ServiceName,
} from '@ubii/proto';
import { asObject, defaultJson } from '../message-form/default-json.ts';

/** Request type of a service; undefined when it takes none. */
export function requestType(service: ServiceName): MessageDescriptor | undefined {
  const { requestFormat } = SERVICES[service];
  return requestFormat === '' ? undefined : messageDescriptor(requestFormat);
}

/** Initial request; members for a client id contain that of this page. */
export function newRequest(service: ServiceName, clientId: string): JsonObject {
  const type = requestType(service);
  if (type === undefined) return {};
  const json = asObject(defaultJson(type));
  return type.fieldByName.has('clientId') ? { ...json, clientId } : json;
}

/** Returns the problems because of which a request cannot be sent. */
export function checkRequest(service: ServiceName, json: JsonObject): JsonProblem[] {
  const type = SERVICES[service].requestFormat;
  return type === '' ? [] : findJsonProblems(type as MessageType, json);
}
