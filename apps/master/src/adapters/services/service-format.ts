import { DecodeError, decode, encode, fromJson, toJson } from '@ubii/proto';
import type { Init, ServiceReply, ServiceRequest } from '@ubii/proto';

const REQUEST = 'ubii.services.ServiceRequest';
const REPLY = 'ubii.services.ServiceReply';

/** Name of a format. */
export type FormatName = 'json' | 'binary';

/** Codec of service requests and replies. */
export interface ServiceFormat {
  readonly name: FormatName;
  readonly contentType: string;
  /** @throws DecodeError when the bytes are no service request */
  decodeRequest(bytes: Uint8Array): ServiceRequest;
  encodeReply(reply: Init<ServiceReply>): Buffer | string;
}

/** [SV-3, SV-4] */
export const jsonFormat: ServiceFormat = {
  name: 'json',
  contentType: 'application/json; charset=utf-8',
  decodeRequest: (bytes) => fromJson(REQUEST, parseJson(bytes)),
  encodeReply: (reply) => JSON.stringify(toJson(REPLY, reply)),
};

export const binaryFormat: ServiceFormat = {
  name: 'binary',
  contentType: 'application/octet-stream',
  decodeRequest: (bytes) => decode(REQUEST, bytes),
  encodeReply: (reply) => {
    const { buffer, byteOffset, byteLength } = encode(REPLY, reply);
    return Buffer.from(buffer, byteOffset, byteLength);
  },
};

/** Every format, by name. */
export const FORMATS: { readonly [F in FormatName]: ServiceFormat } = {
  json: jsonFormat,
  binary: binaryFormat,
};

/** The format for `POST /services`: JSON unless the content type says binary, as old clients expect. */
export function formatOf(contentType: string | undefined): ServiceFormat {
  return /^application\/(octet-stream|(x-|vnd\.google\.)?protobuf)\b/i.test(contentType ?? '')
    ? binaryFormat
    : jsonFormat;
}

/** Bytes that are no UTF-8 become U+FFFD, as in other servers for these clients. [SV-48] */
function parseJson(bytes: Uint8Array): unknown {
  try {
    return JSON.parse(Buffer.from(bytes.buffer, bytes.byteOffset, bytes.byteLength).toString());
  } catch (cause) {
    const reason = cause instanceof Error ? cause.message : String(cause);
    throw new DecodeError(REQUEST, bytes.byteLength, reason, cause);
  }
}
