// Attacker of the test network: keeps as many idle connections open as it gets, from several addresses. Prints a line
// when the first were refused, and goes on until it is killed.
import { connect } from 'node:net';

const { host, port, addresses, each } = JSON.parse(process.argv[2] ?? '');
let refused = 0;
function hold(localAddress) {
  const socket = connect({ host, port, localAddress });
  socket.on('error', () => undefined);
  socket.once('close', () => {
    if (++refused === each) process.stdout.write('refused\n');
    setTimeout(() => hold(localAddress), 20);
  });
}
for (const address of addresses) for (let i = 0; i < each; i++) hold(address);
