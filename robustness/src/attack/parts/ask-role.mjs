// Prints the number of the role that the master gives to the user of this process.
const response = await fetch(`http://localhost:${process.argv[2]}/services/json`, {
  method: 'POST',
  headers: { 'content-type': 'application/json' },
  body: '{"topic":"/services/ubii/join_check","joinCheckRequest":{}}',
});
const { joinCheck } = await response.json();
const names = ['NONE', 'ADMIN', 'PARTICIPANT', 'PLAYER', 'VIEWER'];
const role = joinCheck?.role ?? 0;
console.log(typeof role === 'number' ? role : names.indexOf(role.replace('ACCESS_ROLE_', '')));
