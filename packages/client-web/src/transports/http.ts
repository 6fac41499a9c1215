import { DecodeError, decode, encode, fromJson, toJson } from '@ubii/proto';
import type { Init, ServiceReply, ServiceRequest } from '@ubii/proto';
import { ConnectionError } from '../core/connection/connection-error.ts';
import type { ServiceTransport } from '../core/ports/service-transport.ts';

/** Encoding of service requests. */
export type ServiceEncoding = 'binary' | 'json';

/** URL and encoding of services. */
export interface HttpServicesOptions {
  /** Full URL of the endpoint, such as `http://localhost:8080/services/binary`. */
  readonly url: string;
  /** @default from the URL: `json` when its path ends with `/json` or `/services` */
  readonly encoding?: ServiceEncoding;
  /** @default the global `fetch` */
  readonly fetch?: typeof globalThis.fetch;
}

const REQUEST = 'ubii.services.ServiceRequest';
const REPLY = 'ubii.services.ServiceReply';

/** Services over HTTP POST, one request each. [SV-1] */
export function createHttpServices(options: HttpServicesOptions): ServiceTransport {
  const { url } = options;
  const codec = CODECS[options.encoding ?? encodingOf(url)];
  // Called as a bare function: a browser's fetch refuses another `this`.
  const fetch = options.fetch ?? globalThis.fetch.bind(globalThis);
  return {
    send(request, bearer) {
      const abort = new AbortController();
      return { reply: exchange(request, bearer, abort.signal), cancel: () => abort.abort() };
    },
  };

  async function exchange(
    request: Init<ServiceRequest>,
    bearer: string | undefined,
    signal: AbortSignal,
  ): Promise<ServiceReply> {
    let response: Response;
    let body: ArrayBuffer;
    try {
      response = await fetch(url, {
        method: 'POST',
        headers: {
          'Content-Type': codec.contentType,
          ...(bearer === undefined ? {} : { Authorization: `Bearer ${bearer}` }), // [AC-13]
        },
        body: codec.encode(request),
        // What shows who the client is goes to this address and no other.
        redirect: 'error',
        signal,
      });
      body = await response.arrayBuffer();
    } catch (cause) {
      if (signal.aborted) throw new ConnectionError('closed', 'The request was cancelled');
      throw new ConnectionError('refused', `The master cannot be reached at ${url}`, { cause });
    }
    if (!response.ok) {
      throw new ConnectionError(
        'refused',
        reasonIn(body) ?? `Expected status 200 of ${url}, received ${response.status}`,
      );
    }
    try {
      return codec.decode(new Uint8Array(body));
    } catch (cause) {
      throw new ConnectionError('protocol', `Expected a service reply from ${url}`, { cause });
    }
  }
}

/** The sentence of a master that refuses a request before it is a service call, such as of a page that may not call. */
function reasonIn(body: ArrayBuffer): string | undefined {
  try {
    const reply = fromJson(REPLY, JSON.parse(new TextDecoder().decode(body)));
    return reply.error?.message || undefined;
  } catch {
    return undefined; // Not of a master.
  }
}

/** Encoding of services at a URL, from its path. */
function encodingOf(url: string): ServiceEncoding {
  const path = url.replace(/[?#].*$/, '').replace(/\/+$/, '');
  return path.endsWith('/json') || path.endsWith('/services') ? 'json' : 'binary';
}

interface Codec {
  readonly contentType: string;
  encode(request: Init<ServiceRequest>): BodyInit;
  /** @throws {DecodeError} if the body is not a reply */
  decode(body: Uint8Array): ServiceReply;
}

const CODECS: Record<ServiceEncoding, Codec> = {
  binary: {
    contentType: 'application/octet-stream',
    encode: (request) => new Uint8Array(encode(REQUEST, request)),
    decode: (body) => decode(REPLY, body),
  },
  json: {
    contentType: 'application/json',
    encode: (request) => JSON.stringify(toJson(REQUEST, request)),
    decode(body) {
      let json: unknown;
      try {
        json = JSON.parse(new TextDecoder().decode(body));
      } catch (cause) {
        throw DecodeError.wrap(REPLY, body.byteLength, cause);
      }
      return fromJson(REPLY, json);
    },
  },
};
