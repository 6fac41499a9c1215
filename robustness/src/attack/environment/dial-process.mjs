// Opens connections in the network namespace that it was started in, and hands them to its parent.
import { connect } from 'node:net';

process.on('message', ({ id, host, port, from }) => {
  const socket = connect({ host, port, localAddress: from });
  const refuse = (error) => process.send({ id, problem: error.message });
  socket.once('error', refuse);
  socket.once('connect', () => {
    socket.off('error', refuse);
    socket.on('error', () => {});
    process.send({ id }, socket);
  });
});
process.on('disconnect', () => process.exit(0));
