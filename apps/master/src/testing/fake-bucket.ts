import { createServer, type Server, type ServerResponse } from 'node:http';
import type { AddressInfo } from 'node:net';

/** Response of a bucket instead of a file. */
export interface BucketAnswer {
  readonly status?: number;
  readonly headers?: Readonly<Record<string, string>>;
  readonly body?: Uint8Array;
  /** Behaviour after the body: end the response, cut the connection, or send nothing more. */
  readonly then?: 'end' | 'cut' | 'silence';
}

/** A server of files on loopback, as publishers and mirrors of models are. */
export class FakeBucket {
  readonly #server: Server;
  readonly #files: ReadonlyMap<string, Uint8Array>;
  /** Its address, with a slash at the end. */
  readonly url: string;
  /** Paths that were asked for. */
  readonly asked: string[] = [];
  /** Answers that differ from the files, by path. */
  readonly answers = new Map<string, BucketAnswer>();
  /** Called with each path that is asked for, before the answer. */
  onRequest: (path: string) => Promise<void> | void = () => undefined;

  private constructor(server: Server, files: Readonly<Record<string, Uint8Array>>) {
    this.#files = new Map(Object.entries(files));
    this.#server = server;
    this.url = `http://127.0.0.1:${(server.address() as AddressInfo).port}/`;
    server.on('request', (request, response) => {
      const path = (request.url ?? '/').slice(1);
      this.asked.push(path);
      void Promise.resolve(this.onRequest(path)).then(() => this.#answer(path, response));
    });
  }

  /** @param files by path, without a slash at the beginning */
  static async open(files: Readonly<Record<string, Uint8Array>>): Promise<FakeBucket> {
    const server = createServer();
    await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
    return new FakeBucket(server, files);
  }

  close(): Promise<void> {
    this.#server.closeAllConnections();
    return new Promise((resolve) => this.#server.close(() => resolve()));
  }

  #answer(path: string, response: ServerResponse): void {
    const file = this.#files.get(path);
    const answer =
      this.answers.get(path) ?? (file === undefined ? { status: 404 } : { body: file });
    response.writeHead(answer.status ?? 200, answer.headers);
    response.write(answer.body ?? '', () => {
      if (answer.then === 'cut') response.destroy();
      else if (answer.then !== 'silence') response.end();
    });
  }
}
