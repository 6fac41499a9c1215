/**
 * A thread that sends the same request again and again, each as soon as the one before is answered, so that
 * what measures is not held up by what it sends.
 */
import { request } from 'node:http';
import { parentPort, workerData } from 'node:worker_threads';

const { url, headers, body } = workerData;
let isRunning = true;

parentPort.on('message', () => {
  isRunning = false;
});

/** Resolves when the request is answered or its connection is closed, which is how some are refused. */
function send() {
  return new Promise((resolve) => {
    const outgoing = request(url, { method: 'POST', headers }, (response) => {
      const chunks = [];
      response.on('data', (chunk) => chunks.push(chunk));
      response.on('end', () => resolve(Buffer.concat(chunks).toString()));
      response.on('error', () => resolve(''));
    });
    outgoing.on('error', () => resolve(''));
    outgoing.end(body);
  });
}

let answers = 0;
let last = '';
while (isRunning) {
  const answer = await send();
  answers += 1;
  if (answer !== '') last = answer.slice(0, 1000);
  // Lets the word that it is over come in.
  await new Promise((resolve) => setImmediate(resolve));
}
parentPort.postMessage({ answers, last });
parentPort.close();
