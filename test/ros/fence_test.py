#!/usr/bin/python3
"""Who can reach the demo: the sockets as in doc/operating.md, and that the fence holds."""
import os
import socket
import subprocess

from processes import SIMULATION_NODE, Processes
SCRIPTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', 'scripts')
FENCE = os.path.join(SCRIPTS, 'fence')
LISTENS = '0A'
FENCED = """
rosmaster --core -p 11311 & master=$!
until rosparam list >/dev/null 2>&1; do sleep 0.1; done
"$SIMULATION_NODE" __name:=sim _scene:=small _threads:=1 & node=$!
until rosservice call /sim/get_state >/dev/null 2>&1; do sleep 0.1; done
echo served $node
read -r _
kill -INT $node
kill -TERM $master
wait
"""


def listening(pid):
    """Addresses and ports at which a process listens, in its own network namespace."""
    sockets = set()
    for fd in os.listdir('/proc/%d/fd' % pid):
        try:
            sockets.add(os.readlink('/proc/%d/fd/%s' % (pid, fd)))
        except FileNotFoundError:
            pass  # closed meanwhile
    found = []
    with open('/proc/%d/net/tcp' % pid, encoding='ascii') as table:
        for line in list(table)[1:]:
            words = line.split()
            if words[3] == LISTENS and 'socket:[%s]' % words[9] in sockets:
                address, port = words[1].split(':')
                found.append((socket.inet_ntoa(bytes.fromhex(address)[::-1]), int(port, 16)))
    return found


class Fence(Processes):
    def demo_environment(self):
        """What scripts/demo sets for all that it starts."""
        shell = 'source %s/lib/lib.sh; use_private_master; env' % SCRIPTS
        env = dict(os.environ, ROS_HOSTNAME='elsewhere', ROS_IP='10.0.0.1')
        lines = subprocess.run(['bash', '-c', shell], env=env, check=True, text=True,
                               stdout=subprocess.PIPE).stdout.splitlines()
        return dict(line.split('=', 1) for line in lines if line.startswith('ROS_'))

    def test_demo_is_on_loopback_but_for_one_socket_of_roscpp(self):
        demo = self.demo_environment()
        self.assertEqual(demo['ROS_IP'], '127.0.0.1')
        self.assertNotIn('ROS_HOSTNAME', demo)
        self.assertTrue(demo['ROS_MASTER_URI'].startswith('http://127.0.0.1:'))
        self.env.update(demo)
        self.port = int(demo['ROS_MASTER_URI'].rsplit(':', 1)[1])
        master = self.start_master()
        node = self.start_node('scene:=small', 'threads:=1')
        self.state()
        self.assertEqual({address for address, _ in listening(master.pid)}, {'127.0.0.1'})
        # As in doc/operating.md: data on loopback, the node's XML-RPC on every interface.
        self.assertEqual(sorted(address for address, _ in listening(node.pid)),
                         ['0.0.0.0', '127.0.0.1'])

    def test_nobody_reaches_what_is_fenced(self):
        if subprocess.run(['unshare', '-rn', 'true'], check=False, capture_output=True).returncode:
            self.skipTest('this machine allows no network namespaces')
        self.env.update(ROS_MASTER_URI='http://127.0.0.1:11311', SIMULATION_NODE=SIMULATION_NODE)
        fenced = self.start('timeout', '60', FENCE, 'bash', '-c', FENCED, stdin=subprocess.PIPE)
        line = fenced.stdout.readline()
        while not line.startswith('served'):
            self.assertTrue(line, 'the fenced node does not serve')
            line = fenced.stdout.readline()
        ports = [port for _, port in listening(int(line.split()[1]))]
        self.assertEqual(len(ports), 2)
        for port in ports:
            with socket.socket() as probe:
                self.assertNotEqual(probe.connect_ex(('127.0.0.1', port)), 0)
        fenced.communicate('\n', timeout=20)
        self.assertNotEqual(fenced.returncode, 124)  # ended by itself

    def test_says_what_it_lacks(self):
        answer = subprocess.run([FENCE], check=False, text=True, capture_output=True)
        self.assertEqual(answer.returncode, 1)
        self.assertIn('nothing to run', answer.stderr)


if __name__ == '__main__':
    import rostest
    rostest.rosrun('ice_ice_baby', 'fence', Fence)
